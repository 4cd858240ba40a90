// SPDX-License-Identifier: MIT
// a x from rows of logic cells, 17 a bit of a. Combinational.
module glint_rows #(
    parameter BITS = 5 // of a, 2 or more
) (
    input [BITS-1:0] a,
    input [15:0] x,
    output [BITS+15:0] product
);
    genvar i;
    generate
        for (i = 1; i < BITS; i = i + 1) begin : bits
            wire [i+15:0] was; // times the bits of a below i
            if (i == 1) assign was = {1'b0, x & {16{a[0]}}};
            else assign was = bits[i-1].is;
            wire [i+16:0] is;
            assign is[i-1:0] = was[i-1:0];
            glint_row #(16) row (
                .add(a[i]),
                .sum(was[i+15:i]),
                .more(x),
                .result(is[i+16:i])
            );
        end
    endgenerate
    assign product = bits[BITS-1].is[BITS+15:0];
endmodule
