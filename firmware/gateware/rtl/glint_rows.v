// SPDX-License-Identifier: MIT
// a x from rows of logic cells, 17 a bit of a. Combinational.
`default_nettype none

module glint_rows #(
    parameter integer BITS = 5, // of a, 2 or more
    parameter integer ROW_AND = 0 // as in glint_row
) (
    input wire [BITS-1:0] a,
    input wire [15:0] x,
    output wire [BITS+15:0] product
);
    genvar i;
    generate
        for (i = 1; i < BITS; i = i + 1) begin : bits
            wire [i+15:0] was; // times the bits of a below i
            if (i == 1) assign was = {1'b0, x & {16{a[0]}}};
            else assign was = bits[i-1].is;
            wire [i+16:0] is;
            assign is[i-1:0] = was[i-1:0];
            glint_row #(
                .WIDTH(16),
                .ROW_AND(ROW_AND)
            ) row (
                .add(a[i]),
                .sum(was[i+15:i]),
                .more(x),
                .result(is[i+16:i])
            );
        end
        if (BITS < 2) begin : range
            BITS_must_be_2_or_more stop ();
        end
    endgenerate
    assign product = bits[BITS-1].is[BITS+15:0];
endmodule

`default_nettype wire
