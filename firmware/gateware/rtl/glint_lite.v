// SPDX-License-Identifier: MIT
// Purpose: F of any function of the library for one material, from a table that the user fills: a line between exact
// values, 16 to each octave of u = 2^16 - c, and every u below 32. No multiplier blocks, one pair of block RAMs.
// Parameters: as glint_core's.
// Latency: a pixel a clock, 6 clocks later.
// Reset, back-pressure: as glint_core's; the table stays as it is through a reset.
//
// Entry i holds F(u_i), 17 bits, above F(u_i) - F(u_i+1), 15 bits of which 12 are used, Q16.16:
//   u_i = i for i < 16, else (16 + i mod 16) << (i / 16 - 1);  i = 0..207, u_208 = 65536.
`default_nettype none

module glint_lite #(
    parameter integer USER = 1, // 1 or more
    parameter integer LUT_RAM = 0, // 0 or 1
    parameter integer ROW_AND = 0 // 0 or 1
) (
    input wire clk,
    input wire rst,
    input wire t_write, // the table's port; only while idle
    input wire [7:0] t_entry,
    input wire [31:0] t_value,
    input wire [16:0] c_min, // the cutoff: F = 0 where c < c_min; held still unless idle
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
    localparam CLOCKS = 6;

    // The pipeline stands still while its last pixel waits.
    reg [CLOCKS:1] valid;
    wire en = !m_valid || m_ready;
    assign s_ready = en;
    assign m_valid = valid[CLOCKS];
    assign idle = valid == 0;
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
    glint_row #(.WIDTH(12), .ROW_AND(ROW_AND))
        row_sum1 (.add(part4[4]), .sum(sum0[12:1]), .more(entry4[11:0]), .result(sum1));
    glint_row #(.WIDTH(12), .ROW_AND(ROW_AND))
        row_sum2 (.add(part4[5]), .sum(sum1[12:1]), .more(entry4[11:0]), .result(sum2));
    glint_row #(.WIDTH(12), .ROW_AND(ROW_AND))
        row_sum3 (.add(part4[6]), .sum(sum2[12:1]), .more(entry4[11:0]), .result(sum3));
    glint_row #(.WIDTH(12), .ROW_AND(ROW_AND))
        row_sum4 (.add(part5[7]), .sum(was5[12:1]), .more(entry5[11:0]), .result(sum4));
    glint_row #(.WIDTH(12), .ROW_AND(ROW_AND))
        row_sum5 (.add(part5[8]), .sum(sum4[12:1]), .more(entry5[11:0]), .result(sum5));
    glint_row #(.WIDTH(12), .ROW_AND(ROW_AND))
        row_sum6 (.add(part5[9]), .sum(sum5[12:1]), .more(entry5[11:0]), .result(sum6));
    glint_row #(.WIDTH(12), .ROW_AND(ROW_AND))
        row_sum7 (.add(part5[10]), .sum(sum6[12:1]), .more(entry5[11:0]), .result(sum7));
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

    wire unused = &{1'b0, zero[6], u3[2:0], entry5[14:12], sum0[0], sum1[0], sum2[0], sum4[0], was5[0], sum5[0],
        sum6[0], sum7[0]};
endmodule

`default_nettype wire
