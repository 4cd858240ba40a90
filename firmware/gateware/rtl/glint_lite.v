// SPDX-License-Identifier: MIT
// F of any function of the library for one material, from a table that the user fills: a line between exact values, 16 to each
// octave of u = 2^16 - c, and every u below 32. A pixel a clock, 6 clocks later. No multiplier blocks, one pair of block RAMs.
//
// Entry i holds F(u_i), 17 bits, above F(u_i) - F(u_i+1), 15 bits of which 12 are used, Q16.16:
//   u_i = i for i < 16, else (16 + i mod 16) << (i / 16 - 1);  i = 0..207, u_208 = 65536.
module glint_lite #(
    parameter USER = 1
) (
    input clk,
    input rst,
    input t_write,  // the table's port; not while pixels are on their way
    input [7:0] t_entry,
    input [31:0] t_value,
    input [16:0] c_min,  // the cutoff: F = 0 where c < c_min; held still while pixels are on their way
    input s_valid,
    output s_ready,
    input signed [17:0] s_c,  // the cosine, Q16.16; below 0 counts as 0, above 65536 as 65536
    input [USER-1:0] s_user,  // comes out with the pixel's F
    output m_valid,
    input m_ready,
    output [16:0] m_f,  // F, Q16.16
    output [USER-1:0] m_user
);
    localparam CLOCKS = 6;

    // The pipeline stands still while its last pixel waits.
    reg [CLOCKS:1] valid;
    wire en = !m_valid || m_ready;
    assign s_ready = en;
    assign m_valid = valid[CLOCKS];
    always @(posedge clk)
        if (rst) valid <= 0;
        else if (en) valid <= {valid[CLOCKS-1:1], s_valid};

    // 1: u. That of c = 0 becomes 0, too, but its F is 0 like those beyond the cutoff.
    reg [15:0] u1;
    reg [6:1] zero;
    wire [16:0] minus_c = 17'h10000 - {1'b0, s_c[15:0]};
    always @(posedge clk)
        if (en) begin
            u1 <= s_c[16] ? 16'd0 : minus_c[15:0];
            zero <= {zero[5:1], s_c[17] || s_c < $signed({1'b0, c_min}) || (minus_c[16] && !s_c[16])};
        end

    // 2, 3: shifted left until bit 15 is set, but by no more than 11.
    wire far8 = ~|u1[15:8];
    wire [15:0] u8 = far8 ? {u1[7:0], 8'd0} : u1;
    wire far4 = ~|u8[15:12] & ~far8;
    reg [15:0] u2, u3;
    reg [3:0] octave2, octave3;
    wire far2 = ~|u2[15:14];
    wire [15:0] u2_2 = far2 ? {u2[13:0], 2'd0} : u2;
    wire far1 = ~u2_2[15];
    always @(posedge clk)
        if (en) begin
            u2 <= far4 ? {u8[11:0], 4'd0} : u8;
            octave2 <= 4'd11 - {far8, far4, 2'd0};
            u3 <= far1 ? {u2_2[14:0], 1'b0} : u2_2;
            octave3 <= octave2 - {2'd0, far2, far1};
        end

    // 4: the entry.
    (* ram_style = "block" *) reg [31:0] entries[0:255];
    reg [31:0] entry4, entry5;
    reg [10:3] part4;
    always @(posedge clk) begin
        if (t_write) entries[t_entry] <= t_value;
        if (en) entry4 <= entries[{octave3 + {3'd0, u3[15]}, u3[14:11]}];
    end

    // 5, 6: less its part of the difference.
    reg [10:7] part5;
    reg [12:0] was5;
    wire [12:0] sum0 = part4[3] ? {1'b0, entry4[11:0]} : 13'd0;
    wire [12:0] sum1, sum2, sum3, sum4, sum5, sum6, sum7;
    glint_row #(12) row_sum1 (part4[4], sum0[12:1], entry4[11:0], sum1);
    glint_row #(12) row_sum2 (part4[5], sum1[12:1], entry4[11:0], sum2);
    glint_row #(12) row_sum3 (part4[6], sum2[12:1], entry4[11:0], sum3);
    glint_row #(12) row_sum4 (part5[7], was5[12:1], entry5[11:0], sum4);
    glint_row #(12) row_sum5 (part5[8], sum4[12:1], entry5[11:0], sum5);
    glint_row #(12) row_sum6 (part5[9], sum5[12:1], entry5[11:0], sum6);
    glint_row #(12) row_sum7 (part5[10], sum6[12:1], entry5[11:0], sum7);
    reg [16:0] f6;
    always @(posedge clk)
        if (en) begin
            part4 <= u3[10:3];
            part5 <= part4[10:7];
            was5 <= sum3;
            entry5 <= entry4;
            f6 <= zero[5] ? 17'd0 : entry5[31:15] - {5'd0, sum7[12:1]};
        end
    assign m_f = f6;

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

    wire unused = &{1'b0, zero[6], u3[2:0], entry5[14:12], sum0[0], sum1[0], sum2[0], sum4[0], was5[0], sum5[0], sum6[0], sum7[0]};
endmodule
