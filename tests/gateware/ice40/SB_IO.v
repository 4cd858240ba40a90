// SPDX-License-Identifier: MIT
// The primitive's ports that boards use, for their lint.
`default_nettype none

module SB_IO #(
    parameter [5:0] PIN_TYPE = 0
) (
    output wire PACKAGE_PIN,
    input wire OUTPUT_CLK,
    input wire CLOCK_ENABLE,
    input wire D_OUT_0,
    input wire D_OUT_1
);
    assign PACKAGE_PIN = OUTPUT_CLK && CLOCK_ENABLE ? D_OUT_0 : D_OUT_1;
    wire unused = &{1'b0, PIN_TYPE};
endmodule

`default_nettype wire
