// SPDX-License-Identifier: MIT
// A delay of no clocks, for where the other registers are wires, too.
`default_nettype none

module glint_delay #(
    parameter integer WIDTH = 16,
    parameter integer CLOCKS = 4,
    parameter integer LUT_RAM = 0
) (
    input wire clk,
    input wire rst,
    input wire en,
    input wire [WIDTH-1:0] d,
    output wire [WIDTH-1:0] q
);
    assign q = d;
endmodule
`default_nettype wire
