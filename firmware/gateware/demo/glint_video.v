// SPDX-License-Identifier: MIT
// 640x480 at 60 Hz: 800 clocks of 25.175 MHz a line, 525 lines, both syncs negative. The picture comes first.
`default_nettype none

module glint_video (
    input wire clk,
    input wire rst,
    output reg [9:0] x,
    output reg [9:0] y,
    output wire line_end, // the line's last clock
    output wire visible,
    output wire hsync,
    output wire vsync
);
    assign line_end = x == 799;
    assign visible = x < 640 && y < 480;
    assign hsync = !(x >= 656 && x < 752);
    assign vsync = !(y >= 490 && y < 492);
    always @(posedge clk)
        if (rst) begin
            x <= 0;
            y <= 0;
        end else begin
            x <= line_end ? 10'd0 : x + 10'd1;
            if (line_end) y <= y == 524 ? 10'd0 : y + 10'd1;
        end
endmodule

`default_nettype wire
