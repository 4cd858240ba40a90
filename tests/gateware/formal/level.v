// SPDX-License-Identifier: MIT
// glint_level for every sum: the nearest of the levels to min(1, y).
`default_nettype none

module level (
    input wire [33:0] y
);
    wire [33:0] one = 34'h100000000;
    wire [39:0] at_most_1 = {6'd0, y > one ? one : y};
    wire [4:0] level5;
    wire [5:0] level6;
    glint_level #(
        .BITS(5)
    ) of_5 (
        .y(y),
        .level(level5)
    );
    glint_level #(
        .BITS(6)
    ) of_6 (
        .y(y),
        .level(level6)
    );
    always @* begin
        assert ({35'd0, level5} == (at_most_1 * 40'd31 + 40'h80000000) >> 32);
        assert ({34'd0, level6} == (at_most_1 * 40'd63 + 40'h80000000) >> 32);
    end
endmodule

`default_nettype wire
