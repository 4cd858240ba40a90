// SPDX-License-Identifier: MIT
// Purpose: F of the modified Schlick function or of Schlick's, in Q16.16, from the cosine, with the bits of glint_msh()
// and glint_schlick(): correctly rounded, ties up.
// Parameters: USER, bits that travel with a pixel; LUT_RAM, 1 on parts whose logic cells can be memory; ROW_AND, 1
// where rows fit carry chains better as sum + (more & add) (Xilinx).
// Latency: a pixel a clock, 12 clocks later.
// Reset: synchronous, active high; empties the pipeline. What is offered in that clock is lost.
// Back-pressure: while the last pixel waits all stages stand still; s_ready follows m_ready in the same clock
// (glint_skid breaks that path). Registers may change in a clock in which idle is 1 and no pixel is taken.
//
// The digit after a name is the clock it holds at.
// With C the cosine, u = 2^16 - C, 4D = 4(n - 1)u + 2^18, E = 4D + C:  F 2^16 = 2^39 C / 5E^2 or 2^18 C / 4D (Schlick).
//  1. y        E or 4D, times 2^(9 - octave): 2^27 <= y < 2^28. Then F 2^(16+t) = 2^57 C / 5y^2 or 2^27 C / y,
//              t = 2 octave or octave
//  2. q        that by a table, off by less than 2^t / 2; h = floor(q / 2^t), so that F 2^16, rounded, is h or h + 1
//  3. F        h + 1 where (h + 1/2) 2^t times the divisor, 5y^2 / 2^30 or y, is at most 2^27 C
`default_nettype none

module glint_core #(
    parameter integer USER = 1, // 1 or more
    parameter integer LUT_RAM = 0, // 0 or 1
    parameter integer ROW_AND = 0 // 0 or 1
) (
    input wire clk,
    input wire rst,
    input wire model, // 0: modified Schlick, 1: Schlick. Like n and c_min held still unless idle
    input wire [9:0] n, // the shininess, 1..1000; others are clamped
    input wire [16:0] c_min, // the cutoff: F = 0 where c < c_min
    input wire s_valid,
    output wire s_ready,
    input wire signed [17:0] s_c, // the cosine, Q16.16; below 0 counts as 0, above 65536 as 65536
    input wire [USER-1:0] s_user, // comes out with the pixel's F
    output wire m_valid,
    input wire m_ready,
    output wire [16:0] m_f, // F, Q16.16
    output wire [USER-1:0] m_user,
    output wire idle // no pixel is inside
);
    localparam CLOCKS = 12;

    // The pipeline stands still while its last pixel waits.
    reg [CLOCKS:1] valid;
    wire en = !m_valid || m_ready;
    assign s_ready = en;
    assign m_valid = valid[CLOCKS];
    assign idle = valid == 0;
    always @(posedge clk)
        if (rst) valid <= 0;
        else if (en) valid <= {valid[CLOCKS-1:1], s_valid};

    reg [9:0] n_less_1;
    always @(posedge clk) n_less_1 <= n == 0 ? 10'd0 : n > 10'd1000 ? 10'd999 : n - 10'd1;

    // 1: the cosine, clamped. That of 0 becomes u = 0, too, but its F is 0 like those beyond the cutoff.
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

    // 2 to 4: the denominator and its mantissa. E >= 2^27 makes F 2^16 less than 0.4.
    reg [31:0] w2_high;
    reg [1:0] w2_low;
    wire [27:0] w2 = {w2_high[25:0], w2_low};
    reg [12:2] zero;
    always @(posedge clk)
        if (en) begin
            w2_high <= {22'd0, n_less_1} * {16'd0, u1} + {16'd1, 1'b0, c1[16:2]};
            w2_low <= c1[1:0];
            zero <= {zero[11:3], zero[2] || (w2[27] && !model), zero1};
        end
    wire [27:0] y3_next, y4;
    wire [3:0] octave4;
    glint_normalize normalize (
        .clk(clk),
        .en(en),
        .w(w2),
        .next(y3_next),
        .y(y4),
        .octave(octave4)
    );

    // 5 to 9: the divisor.
    wire [37:0] s9;
    glint_divisor #(.ROW_AND(ROW_AND)) divisor (
        .clk(clk),
        .en(en),
        .model(model),
        .y(y4[27:1]),
        .s(s9)
    );

    // 4 to 7: the reciprocal.
    wire [18:0] z7;
    glint_reciprocal #(.ROW_AND(ROW_AND)) reciprocal (
        .clk(clk),
        .en(en),
        .model(model),
        .y(y3_next[26:8]),
        .z(z7)
    );

    // 8: times C = p + 1.
    wire [15:0] u7;
    glint_delay #(
        .WIDTH(16),
        .CLOCKS(6),
        .LUT_RAM(LUT_RAM)
    ) u_1_to_7 (
        .clk(clk),
        .rst(rst),
        .en(en),
        .d(u1),
        .q(u7)
    );
    wire [15:0] p7 = ~u7;
    wire [16:0] low0 = z7[0] ? {1'b0, p7} : 17'd0;
    wire [16:0] low1;
    glint_row #(.WIDTH(16), .ROW_AND(ROW_AND))
        row_low1 (.add(z7[1]), .sum(low0[16:1]), .more(p7), .result(low1));
    wire [16:0] low2;
    glint_row #(.WIDTH(16), .ROW_AND(ROW_AND))
        row_low2 (.add(z7[2]), .sum(low1[16:1]), .more(p7), .result(low2));
    wire [16:0] addend7 = {1'b0, z7[18:3]} + {1'b0, low2[16:1]};
    reg [31:0] product8;
    reg [4:0] t5, t6, t7, t8;
    always @(posedge clk)
        if (en) begin
            product8 <= {16'd0, z7[18:3]} * {16'd0, p7} + {15'd0, addend7};
            t5 <= model ? {1'b0, octave4} : {octave4, 1'b0};
            t6 <= t5;
            t7 <= t6;
            t8 <= t7;
        end
    wire [16:0] q8 = product8[31:15];

    // 9: half units: 2h + 1, then t zeros.
    wire [17:0] keep = 18'h3ffff << t8;
    reg [17:0] g9;
    reg [16:0] h9, h10, h11;
    reg [2:0] t9;
    reg t10;
    always @(posedge clk)
        if (en) begin
            g9 <= keep & ({q8, 1'b0} | ~{keep[16:0], 1'b0});
            h9 <= t8[4] ? {16'd0, q8[16]} : t8[3] ? {8'd0, q8[16:8]} : q8;
            t9 <= t8[2:0];
            h10 <= t9[2] ? (t9[1] ? {6'd0, h9[16:6]} : {4'd0, h9[16:4]}) : t9[1] ? {2'd0, h9[16:2]} : h9;
            t10 <= t9[0];
            h11 <= t10 ? {1'b0, h10[16:1]} : h10;
        end

    // 10, 11: g times s, as g[17:2] times s[37:6] and, in 2^8 of its units, the rest. Less by 1 for Schlick, so that
    // its tie counts as less than C, too; else more by 2^8, which makes up for what is cut off. (For Schlick g[17:2]
    // <= 2^15.)
    wire [5:0] rest4 = s9[4] ? g9[17:12] : 6'd0;
    wire [3:0] rest2 = s9[2] ? g9[17:14] : 4'd0;
    wire [1:0] rest0 = s9[0] ? g9[17:16] : 2'd0;
    wire [7:0] rest5;
    wire [5:0] rest3;
    wire [3:0] rest1;
    glint_row #(.WIDTH(7), .ROW_AND(ROW_AND))
        row_rest5 (.add(s9[5]), .sum({1'b0, rest4}), .more(g9[17:11]), .result(rest5));
    glint_row #(.WIDTH(5), .ROW_AND(ROW_AND))
        row_rest3 (.add(s9[3]), .sum({1'b0, rest2}), .more(g9[17:13]), .result(rest3));
    glint_row #(.WIDTH(3), .ROW_AND(ROW_AND))
        row_rest1 (.add(s9[1]), .sum({1'b0, rest0}), .more(g9[17:15]), .result(rest1));
    wire [5:0] rest_3_to_0 = rest3 + {2'd0, rest1};
    wire [7:0] rest_5_to_0 = rest5 + {2'd0, rest_3_to_0};
    wire [22:0] rest7 = g9[1] ? s9[37:15] : 23'd0;
    wire [23:0] rest8;
    glint_row #(.WIDTH(23), .ROW_AND(ROW_AND))
        row_rest8 (.add(g9[0]), .sum(rest7), .more({1'd0, s9[37:16]}), .result(rest8));
    reg [31:0] product10, product11;
    reg [7:0] low_rest10;
    reg [23:0] high_rest10;
    reg [15:0] g10, s10;
    wire [24:0] rest10 = {1'b0, high_rest10} + {17'd0, low_rest10};
    wire [25:0] carry10 = {{2{product10[31] && model}}, product10[31:8]} + {1'b0, rest10};
    always @(posedge clk)
        if (en) begin
            product10 <= {16'd0, g9[17:2]} * {16'd0, s9[21:6]} + (model ? 32'hffffffff : 32'h100);
            low_rest10 <= rest_5_to_0;
            high_rest10 <= rest8;
            g10 <= g9[17:2];
            s10 <= s9[37:22];
            product11 <= {16'd0, g10} * {16'd0, s10} + {{14{carry10[25]}}, carry10[25:8]};
        end

    // 12: F.
    wire [15:0] u11;
    glint_delay #(
        .WIDTH(16),
        .CLOCKS(4),
        .LUT_RAM(LUT_RAM)
    ) u_7_to_11 (
        .clk(clk),
        .rst(rst),
        .en(en),
        .d(u7),
        .q(u11)
    );
    wire up = product11[31:13] <= {3'd0, ~u11};
    reg [16:0] f12;
    always @(posedge clk) if (en) f12 <= zero[11] ? 17'd0 : h11 + {16'd0, up};
    assign m_f = f12;

    glint_delay #(
        .WIDTH(USER),
        .CLOCKS(CLOCKS),
        .LUT_RAM(LUT_RAM)
    ) user (
        .clk(clk),
        .rst(rst),
        .en(en),
        .d(s_user),
        .q(m_user)
    );

    generate
        if (USER < 1) begin : range
            USER_must_be_1_or_more stop ();
        end
        if (LUT_RAM < 0 || LUT_RAM > 1 || ROW_AND < 0 || ROW_AND > 1) begin : flags
            LUT_RAM_and_ROW_AND_must_be_0_or_1 stop ();
        end
    endgenerate

    wire unused = &{1'b0, w2_high[31:26], zero[12], y4[0], y3_next[27], y3_next[7:0], low2[0], carry10[7:0],
        product10[7:0], product11[12:0], product8[14:0], low0[0], low1[0]};
endmodule

`default_nettype wire
