// SPDX-License-Identifier: MIT
// The primitive's ports that boards use, for their lint.
module SB_IO #(
    parameter [5:0] PIN_TYPE = 0
) (
    output PACKAGE_PIN,
    input OUTPUT_CLK,
    input CLOCK_ENABLE,
    input D_OUT_0,
    input D_OUT_1
);
    assign PACKAGE_PIN = OUTPUT_CLK && CLOCK_ENABLE ? D_OUT_0 : D_OUT_1;
    wire unused = &{1'b0, PIN_TYPE};
endmodule
