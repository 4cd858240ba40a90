// SPDX-License-Identifier: MIT
// What the quotient is multiplied by to be compared with the cosine, in units of 2^-9: 5 y^2 / 2^30, off by less than
// 16 units (modified Schlick), or y (Schlick). Five clocks.
//
// y = 2^12 h + 2 l, as bit 0 is 0:  y^2 / 2^30 = (2^10 h^2 + h l + l^2 / 2^12) / 2^16. By rows of logic cells, as the
// multiplier blocks are left to the core's other products and to its user.
`default_nettype none

module glint_divisor #(
    parameter integer ROW_AND = 0 // as in glint_row
) (
    input wire clk,
    input wire en,
    input wire model,
    input wire [27:1] y,
    output reg [37:0] s
);
    wire [15:0] h = y[27:12];
    wire [10:0] l = y[11:1];

    // h l + l^2 / 2^12 in units of 2^7. Bits left out of its rows cannot change a comparison: where l has many bits F
    // is small and needs few. That was searched for among the nearest ties of all n and c; the tests go over the
    // whole domain. The first is 1 + i^2 / 32 for i = l[10:7]: 1 makes up for what is left out.
    localparam [63:0] SQUARES = 64'h8765443322111111;
    wire [3:0] rest = SQUARES[{l[10:7], 2'd0}+:4];
    wire [9:0] sum1 = {l[1] ? h[15:14] : 2'd0, 4'd0, rest};
    wire [11:0] sum2;
    glint_row #(.WIDTH(8), .ROW_AND(ROW_AND))
        row_sum2 (.add(l[2]), .sum({1'b0, sum1[9:3]}), .more(h[15:8]), .result(sum2[11:3]));
    assign sum2[2:0] = sum1[2:0];
    wire [12:0] sum3;
    glint_row #(.WIDTH(4), .ROW_AND(ROW_AND))
        row_sum3 (.add(l[3]), .sum(sum2[11:8]), .more(h[15:12]), .result(sum3[12:8]));
    assign sum3[7:0] = sum2[7:0];
    wire [13:0] sum4;
    glint_row #(.WIDTH(9), .ROW_AND(ROW_AND))
        row_sum4 (.add(l[4]), .sum(sum3[12:4]), .more(h[15:7]), .result(sum4[13:4]));
    assign sum4[3:0] = sum3[3:0];
    wire [13:0] square7;
    glint_square #(
        .FROM(2),
        .TO(7),
        .ROW_AND(ROW_AND)
    ) square_2_to_7 (
        .h(h[6:0]),
        .low({h[1] & h[0], h[1] & ~h[0], 1'b0, h[0]}),
        .square(square7)
    );

    reg [15:0] h_1;
    reg [10:0] l_1;
    reg [13:0] sum_1;
    reg [13:0] square_1;
    wire [14:0] sum5;
    glint_row #(.WIDTH(9), .ROW_AND(ROW_AND))
        row_sum5 (.add(l_1[5]), .sum(sum_1[13:5]), .more(h_1[15:7]), .result(sum5[14:5]));
    assign sum5[4:0] = sum_1[4:0];
    wire [15:0] sum6;
    glint_row #(.WIDTH(15), .ROW_AND(ROW_AND))
        row_sum6 (.add(l_1[6]), .sum(sum5), .more(h_1[15:1]), .result(sum6[15:0]));
    wire [16:0] sum7;
    glint_row #(.WIDTH(16), .ROW_AND(ROW_AND))
        row_sum7 (.add(l_1[7]), .sum(sum6), .more(h_1), .result(sum7[16:0]));
    wire [23:0] square12;
    glint_square #(
        .FROM(7),
        .TO(12),
        .ROW_AND(ROW_AND)
    ) square_7_to_12 (
        .h(h_1[11:0]),
        .low(square_1),
        .square(square12)
    );

    reg [15:0] h_2;
    reg [10:0] l_2;
    reg [16:0] sum_2;
    reg [23:0] square_2;
    wire [17:0] sum8;
    glint_row #(.WIDTH(15), .ROW_AND(ROW_AND))
        row_sum8 (.add(l_2[8]), .sum(sum_2[16:2]), .more(h_2[15:1]), .result(sum8[17:2]));
    assign sum8[1:0] = sum_2[1:0];
    wire [18:0] sum9;
    glint_row #(.WIDTH(16), .ROW_AND(ROW_AND))
        row_sum9 (.add(l_2[9]), .sum(sum8[17:2]), .more(h_2), .result(sum9[18:2]));
    assign sum9[1:0] = sum8[1:0];
    wire [19:0] sum10;
    glint_row #(.WIDTH(16), .ROW_AND(ROW_AND))
        row_sum10 (.add(l_2[10]), .sum(sum9[18:3]), .more(h_2), .result(sum10[19:3]));
    assign sum10[2:0] = sum9[2:0];
    wire [31:0] square16;
    glint_square #(
        .FROM(12),
        .TO(16),
        .ROW_AND(ROW_AND)
    ) square_12_to_16 (
        .h(h_2),
        .low(square_2),
        .square(square16)
    );

    reg [26:0] y_3;
    reg [19:0] sum_3;
    reg [31:0] square_3;
    reg [36:0] x;
    wire [31:0] high = square_3 + {15'd0, sum_3[19:3]};
    always @(posedge clk)
        if (en) begin
            h_1 <= h;
            l_1 <= l;
            sum_1 <= sum4;
            square_1 <= square7;

            h_2 <= h_1;
            l_2 <= l_1;
            sum_2 <= sum7;
            square_2 <= square12;

            y_3 <= {h_2, l_2};
            sum_3 <= sum10;
            square_3 <= square16;

            x <= model ? {y_3, 10'd0} : {2'd0, high, sum_3[2:0]};
            s <= model ? {1'b0, x} : {1'b0, x} + {x[35:0], 2'd0};
        end
endmodule

`default_nettype wire
