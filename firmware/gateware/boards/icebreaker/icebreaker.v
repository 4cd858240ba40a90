// SPDX-License-Identifier: MIT
// The demo on an iCEBreaker (iCE40 UP5K) with 1BitSquared's 12-bit DVI PMOD at PMOD1A and PMOD1B. The user button
// chooses Schlick's function while it is held.
`default_nettype none

module icebreaker (
    input wire clk_12mhz,
    input wire button_n,
    output wire dvi_clk,
    output wire dvi_hsync,
    output wire dvi_vsync,
    output wire dvi_de,
    output wire [3:0] dvi_red,
    output wire [3:0] dvi_green,
    output wire [3:0] dvi_blue
);
    // 12 MHz 67 / 2^5 = 25.125 MHz: 0.2 % slow, 59.8 frames a second.
    wire clk, locked;
    SB_PLL40_PAD #(
        .FEEDBACK_PATH("SIMPLE"),
        .DIVR(4'd0),
        .DIVF(7'd66),
        .DIVQ(3'd5),
        .FILTER_RANGE(3'd1)
    ) pll (
        .PACKAGEPIN(clk_12mhz),
        .PLLOUTGLOBAL(clk),
        .LOCK(locked),
        .RESETB(1'b1),
        .BYPASS(1'b0)
    );

    reg [1:0] lock = 0; // it belongs to no clock
    reg [3:0] settled = 0; // clocks since the PLL has locked
    reg rst = 1;
    reg [1:0] button;
    always @(posedge clk) begin
        lock <= {lock[0], locked};
        settled <= !lock[1] ? 4'd0 : settled == 15 ? 4'd15 : settled + 4'd1;
        rst <= settled != 15;
        button <= {button[0], !button_n};
    end

    wire hsync, vsync, visible;
    wire [15:0] rgb565;
    glint_demo demo (
        .clk(clk),
        .rst(rst),
        .choose_schlick(button[1]),
        .hsync(hsync),
        .vsync(vsync),
        .visible(visible),
        .rgb565(rgb565)
    );

    // Outputs change with the rising edge, registered in the pins; the transmitter's clock rises half a period later.
    SB_IO #(.PIN_TYPE(6'b010000)) clock_pin (
        .PACKAGE_PIN(dvi_clk),
        .OUTPUT_CLK(clk),
        .CLOCK_ENABLE(1'b1),
        .D_OUT_0(1'b0),
        .D_OUT_1(1'b1)
    );
    // The PMOD has 4 bits of each channel.
    wire [14:0] out = {hsync, vsync, visible, rgb565[15:12], rgb565[10:7], rgb565[4:1]};
    SB_IO #(.PIN_TYPE(6'b010100)) pins[14:0] (
        .PACKAGE_PIN({dvi_hsync, dvi_vsync, dvi_de, dvi_red, dvi_green, dvi_blue}),
        .OUTPUT_CLK(clk),
        .CLOCK_ENABLE(1'b1),
        .D_OUT_0(out),
        .D_OUT_1(15'd0)
    );
    wire unused = &{1'b0, rgb565[11], rgb565[6:5], rgb565[0]};
endmodule

`default_nettype wire
