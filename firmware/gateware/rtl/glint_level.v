// SPDX-License-Identifier: MIT
// The nearest of the levels 0..2^BITS - 1 to min(1, y), 2^32 = 1.0: (y max + 2^31) >> 32. Step 8 in lib/sequence.md
// without its division by 65535, which cancels where the albedo is 255.
`default_nettype none

module glint_level #(
    parameter integer BITS = 5
) (
    input wire [33:0] y,
    output wire [BITS-1:0] level
);
    wire [BITS+31:0] product = {y[31:0], {BITS{1'b0}}} - {{BITS{1'b0}}, y[31:0]};
    wire [BITS:0] rounded = {1'b0, product[BITS+31:32]} + {{BITS{1'b0}}, product[31]};
    assign level = y[33:32] != 0 ? {BITS{1'b1}} : rounded[BITS-1:0];
    wire unused = &{1'b0, product[30:0], rounded[BITS]}; // y < 2^32: at most max - max 2^-32, which rounds to max
endmodule

`default_nettype wire
