// SPDX-License-Identifier: MIT
// From the square of h's low FROM bits, FROM >= 2, that of its low TO bits: each bit b of weight 2^i adds 2^2i + 2^(i+1) (h mod 2^i),
// i + 1 logic cells. Combinational.
module glint_square #(
    parameter FROM = 2,
    parameter TO = 16
) (
    input [TO-1:0] h,
    input [2*FROM-1:0] low,
    output [2*TO-1:0] square
);
    genvar i;
    generate
        for (i = FROM; i < TO; i = i + 1) begin : bits
            wire [2*i-1:0] was;
            if (i == FROM) assign was = low;
            else assign was = bits[i-1].is;
            wire [2*i+1:0] is;
            assign is[i:0] = was[i:0];
            glint_row #(i) row (
                .add(h[i]),
                .sum({h[i], was[2*i-1:i+1]}),
                .more(h[i-1:0]),
                .result(is[2*i+1:i+1])
            );
        end
    endgenerate
    assign square = bits[TO-1].is;
endmodule
