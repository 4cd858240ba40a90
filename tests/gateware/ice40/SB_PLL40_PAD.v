// SPDX-License-Identifier: MIT
// The primitive's ports, for the lint of boards.
`default_nettype none

module SB_PLL40_PAD #(
    parameter FEEDBACK_PATH = "SIMPLE",
    parameter [3:0] DIVR = 0,
    parameter [6:0] DIVF = 0,
    parameter [2:0] DIVQ = 0,
    parameter [2:0] FILTER_RANGE = 0
) (
    input wire PACKAGEPIN,
    output wire PLLOUTGLOBAL,
    output wire LOCK,
    input wire RESETB,
    input wire BYPASS
);
    assign PLLOUTGLOBAL = PACKAGEPIN;
    assign LOCK = RESETB && !BYPASS;
    wire unused = &{1'b0, DIVR, DIVF, DIVQ, FILTER_RANGE, FEEDBACK_PATH == "SIMPLE"};
endmodule

`default_nettype wire
