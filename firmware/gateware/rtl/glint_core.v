// SPDX-License-Identifier: MIT
// F of the modified Schlick function or of Schlick's, in Q16.16, from the cosine, with the bits of glint_msh() and
// glint_schlick(): correctly rounded, ties up. A pixel a clock, 13 clocks later.
//
// With C the cosine, U = 2^16 - C, 4D = 4(n - 1)U + 2^18:  F 2^16 = 2^18 C / 4D (Schlick), 2^39 C / 5E^2, E = 4D + C.
//  1. y        E or 4D, times 2^(9 - octave): 2^27 <= y < 2^28
//  2. h        floor of an approximation of F 2^16 that is off by less than 1/2: C times a reciprocal from a table
//  3. F        h, or h + 1 where F 2^16 >= h + 1/2: h + 1/2 times the divisor is compared with C
module glint_core #(
    parameter USER = 1
) (
    input clk,
    input rst,
    input model,         // 0: modified Schlick, 1: Schlick. Like n and c_min held still while pixels are on their way
    input [9:0] n,       // the shininess, 1..1000; others are clamped
    input [16:0] c_min,  // the cutoff: F = 0 where c < c_min
    input s_valid,
    output s_ready,
    input signed [17:0] s_c,  // the cosine, Q16.16; below 0 counts as 0, above 65536 as 65536
    input [USER-1:0] s_user,  // comes out with the pixel's F
    output m_valid,
    input m_ready,
    output [16:0] m_f,  // F, Q16.16
    output [USER-1:0] m_user
);
    localparam CLOCKS = 13;

    // The pipeline stands still while its last pixel waits.
    reg [CLOCKS:1] valid;
    wire en = !m_valid || m_ready;
    assign s_ready = en;
    assign m_valid = valid[CLOCKS];
    always @(posedge clk)
        if (rst) valid <= 0;
        else if (en) valid <= {valid[CLOCKS-1:1], s_valid};

    reg [9:0] n_less_1;
    always @(posedge clk) n_less_1 <= n == 0 ? 10'd0 : n > 10'd1000 ? 10'd999 : n - 10'd1;

    // 1: the cosine, clamped. u is 2^16 - c, but for c = 0, whose F is 0 like those of the cutoff.
    reg [15:0] u1;
    reg [16:0] c1;
    reg zero1;
    wire [16:0] minus_c = 17'h10000 - {1'b0, s_c[15:0]};
    always @(posedge clk)
        if (en) begin
            u1 <= s_c[16] ? 16'd0 : minus_c[15:0];
            c1 <= model ? 17'd0 : s_c[16] ? 17'h10000 : {1'b0, s_c[15:0]};
            zero1 <= s_c[17] || s_c < $signed({1'b0, c_min}) || (minus_c[16] && !s_c[16]);
        end

    // 2: the denominator.
    reg [27:0] w2;
    reg zero2;
    always @(posedge clk)
        if (en) begin
            w2 <= {16'd0, n_less_1, 2'd0} * {12'd0, u1} + {10'd1, 1'b0, c1};
            zero2 <= zero1;
        end

    // 3, 4: its mantissa.
    wire [27:0] y4;
    wire [3:0] octave4;
    glint_normalize normalize (
        .clk(clk),
        .en(en),
        .w(w2),
        .y(y4),
        .octave(octave4)
    );
    // Beyond E = 2^27 F 2^16 is less than 0.4.
    wire zero3 = zero2 || (w2[27] && !model);

    // 5, 6: the reciprocal.
    wire [18:0] z6;
    glint_reciprocal reciprocal (
        .clk(clk),
        .en(en),
        .model(model),
        .y(y4[26:8]),
        .z(z6)
    );

    // 7, 8: times the cosine, of which there is 2^16 - u = p + 1.
    wire [15:0] u6, u11;
    glint_delay #(
        .WIDTH(16),
        .CLOCKS(5)
    ) u_1_to_6 (
        .clk(clk),
        .rst(rst),
        .en(en),
        .d(u1),
        .q(u6)
    );
    reg [16:0] c7;
    reg [18:0] z7;
    reg [16:0] q8;
    wire [35:0] q = {17'd0, z7} * {19'd0, c7};
    wire unused = &{1'b0, q[35], q[17:0]};
    always @(posedge clk)
        if (en) begin
            c7 <= 17'h10000 - {1'b0, u6};
            z7 <= z6;
            q8 <= {q[34:18]};
        end

    // 9: h above t zeros, and one half.
    wire [4:0] zero_octave8;
    wire zero8 = zero_octave8[4];
    wire [4:0] t8 = model ? {1'b0, zero_octave8[3:0]} : {zero_octave8[3:0], 1'b0};
    glint_delay #(
        .WIDTH(5),
        .CLOCKS(4)
    ) octave_4_to_8 (
        .clk(clk),
        .rst(rst),
        .en(en),
        .d({zero4, octave4}),
        .q(zero_octave8)
    );
    reg zero3r, zero4;
    always @(posedge clk)
        if (en) begin
            zero3r <= zero3;
            zero4 <= zero3r;
        end
    reg [17:0] g9;
    reg [16:0] h9;
    reg zero9;
    wire [17:0] half = 18'd1 << t8;
    always @(posedge clk)
        if (en) begin
            g9 <= ({q8, 1'b0} & ~(half - 18'd1)) | half;
            h9 <= q8 >> t8;
            zero9 <= zero8;
        end

    // The divisor, meanwhile.
    wire [27:0] y7;
    wire [36:0] s9;
    glint_delay #(
        .WIDTH(28),
        .CLOCKS(3)
    ) y_4_to_7 (
        .clk(clk),
        .rst(rst),
        .en(en),
        .d(y4),
        .q(y7)
    );
    glint_divisor divisor (
        .clk(clk),
        .en(en),
        .model(model),
        .y(y7),
        .s(s9)
    );

    // 10 to 13: F.
    glint_delay #(
        .WIDTH(16),
        .CLOCKS(10)
    ) u_1_to_11 (
        .clk(clk),
        .rst(rst),
        .en(en),
        .d(u1),
        .q(u11)
    );
    wire [54:0] p = {37'd0, g9} * {18'd0, s9};
    reg [54:0] p10, p11;
    reg [16:0] h10, h11, f12, f13;
    reg zero10, zero11;
    always @(posedge clk)
        if (en) begin
            p10 <= p;
            p11 <= p10;
            h10 <= h9;
            h11 <= h10;
            zero10 <= zero9;
            zero11 <= zero10;
            f12 <= zero11 ? 17'd0 : h11 + {16'd0, p11 <= {2'd0, 17'h10000 - {1'b0, u11}, 36'd0}};
            f13 <= f12;
        end
    assign m_f = f13;
    glint_delay #(
        .WIDTH(USER),
        .CLOCKS(CLOCKS)
    ) user (
        .clk(clk),
        .rst(rst),
        .en(en),
        .d(s_user),
        .q(m_user)
    );
endmodule
