// SPDX-License-Identifier: MIT
// z, nearly 2^18 times 1.6 / x^2 (modified Schlick) or 1 / x (Schlick), for x = y / 2^27, 1 <= x < 2: a line through
// each of 256 intervals, half way between chord and tangent. Four clocks after y.
`default_nettype none

module glint_reciprocal #(
    parameter integer ROW_AND = 0 // as in glint_row
) (
    input wire clk,
    input wire en,
    input wire model,
    input wire [26:8] y,  // without the leading 1
    output reg [18:0] z
);
    // 2^36 times the function at k / 512.
    function [63:0] f(input schlick, input [63:0] k);
        f = schlick ? (64'd1 << 45) / k : ((64'd8 << 54) / 5) / (k * k);
    endfunction

    // The line's height at the interval's right end, where it is lowest, in 2^-18. It is raised by what cutting
    // products and places short costs in the mean.
    function [18:0] base(input schlick, input [63:0] i);
        /* verilator lint_off UNUSEDSIGNAL */
        reg [63:0] sum;
        /* verilator lint_on UNUSEDSIGNAL */
        begin
            sum = 3 * f(schlick, 514 + 2 * i) + 2 * f(schlick, 513 + 2 * i) - f(schlick, 512 + 2 * i);
            sum = (sum + (schlick ? 64'd24 << 16 : 64'd29 << 16)) >> 20;
            base = sum[18:0];
        end
    endfunction

    // Its rise over the interval, in 2^-19.
    function [12:0] slope(input schlick, input [63:0] i);
        /* verilator lint_off UNUSEDSIGNAL */
        reg [63:0] rise;
        /* verilator lint_on UNUSEDSIGNAL */
        begin
            rise = (f(schlick, 512 + 2 * i) - f(schlick, 514 + 2 * i) + (64'd1 << 16)) >> 17;
            slope = rise[12:0];
        end
    endfunction

    reg [31:0] lines[0:511];
    integer i;
    initial
        for (i = 0; i < 512; i = i + 1)
            lines[i] = {base(i >= 256, {56'd0, i[7:0]}), slope(i >= 256, {56'd0, i[7:0]})};

    // rise * back / 2^12, from back's last bit on.
    reg [31:0] line;
    reg [10:0] back;  // from the right end
    wire [13:0] sum0 = back[0] ? {1'b0, line[12:0]} : 14'd0;
    wire [13:0] sum1;
    glint_row #(.WIDTH(13), .ROW_AND(ROW_AND))
        row_sum1 (.add(back[1]), .sum(sum0[13:1]), .more(line[12:0]), .result(sum1));
    wire [13:0] sum2;
    glint_row #(.WIDTH(13), .ROW_AND(ROW_AND))
        row_sum2 (.add(back[2]), .sum(sum1[13:1]), .more(line[12:0]), .result(sum2));
    wire [13:0] sum3;
    glint_row #(.WIDTH(13), .ROW_AND(ROW_AND))
        row_sum3 (.add(back[3]), .sum(sum2[13:1]), .more(line[12:0]), .result(sum3));
    wire [13:0] sum4;
    glint_row #(.WIDTH(13), .ROW_AND(ROW_AND))
        row_sum4 (.add(back[4]), .sum(sum3[13:1]), .more(line[12:0]), .result(sum4));

    reg [31:0] line_1;
    reg [10:5] back_1;
    reg [13:0] sum_1;
    wire [13:0] sum5;
    glint_row #(.WIDTH(13), .ROW_AND(ROW_AND))
        row_sum5 (.add(back_1[5]), .sum(sum_1[13:1]), .more(line_1[12:0]), .result(sum5));
    wire [13:0] sum6;
    glint_row #(.WIDTH(13), .ROW_AND(ROW_AND))
        row_sum6 (.add(back_1[6]), .sum(sum5[13:1]), .more(line_1[12:0]), .result(sum6));
    wire [13:0] sum7;
    glint_row #(.WIDTH(13), .ROW_AND(ROW_AND))
        row_sum7 (.add(back_1[7]), .sum(sum6[13:1]), .more(line_1[12:0]), .result(sum7));
    wire [13:0] sum8;
    glint_row #(.WIDTH(13), .ROW_AND(ROW_AND))
        row_sum8 (.add(back_1[8]), .sum(sum7[13:1]), .more(line_1[12:0]), .result(sum8));

    reg [31:0] line_2;
    reg [10:9] back_2;
    reg [13:0] sum_2;
    wire [13:0] sum9;
    glint_row #(.WIDTH(13), .ROW_AND(ROW_AND))
        row_sum9 (.add(back_2[9]), .sum(sum_2[13:1]), .more(line_2[12:0]), .result(sum9));
    wire [13:0] sum10;
    glint_row #(.WIDTH(13), .ROW_AND(ROW_AND))
        row_sum10 (.add(back_2[10]), .sum(sum9[13:1]), .more(line_2[12:0]), .result(sum10));

    always @(posedge clk)
        if (en) begin
            line <= lines[{model, y[26:19]}];
            back <= ~y[18:8];
            line_1 <= line;
            back_1 <= back[10:5];
            sum_1 <= sum4;
            line_2 <= line_1;
            back_2 <= back_1[10:9];
            sum_2 <= sum8;
            z <= line_2[31:13] + {7'd0, sum10[13:2]};
        end

    wire unused = &{1'b0, sum0[0], sum1[0], sum2[0], sum3[0], sum5[0], sum6[0], sum7[0], sum9[0], sum10[1:0],
        sum_1[0], sum_2[0]};
endmodule

`default_nettype wire
