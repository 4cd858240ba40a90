// SPDX-License-Identifier: MIT
// From the square of h's low FROM bits, FROM >= 2, that of its low TO bits: each bit b of weight 2^i adds 2^2i +
// 2^(i+1) (h mod 2^i), i + 1 logic cells. Combinational.
`default_nettype none

module glint_square #(
    parameter integer FROM = 2,
    parameter integer TO = 16,
    parameter integer ROW_AND = 0 // as in glint_row
) (
    input wire [TO-1:0] h,
    input wire [2*FROM-1:0] low,
    output wire [2*TO-1:0] square
);
    genvar i;
    generate
        for (i = FROM; i < TO; i = i + 1) begin : bits
            wire [2*i-1:0] was;
            if (i == FROM) assign was = low;
            else assign was = bits[i-1].is;
            wire [2*i+1:0] is;
            assign is[i:0] = was[i:0];
            glint_row #(
                .WIDTH(i),
                .ROW_AND(ROW_AND)
            ) row (
                .add(h[i]),
                .sum({h[i], was[2*i-1:i+1]}),
                .more(h[i-1:0]),
                .result(is[2*i+1:i+1])
            );
        end
        if (FROM < 2 || TO <= FROM) begin : range
            FROM_must_be_2_or_more_and_below_TO stop ();
        end
    endgenerate
    assign square = bits[TO-1].is;
endmodule

`default_nettype wire
