// SPDX-License-Identifier: MIT
// q is d of CLOCKS enabled clocks ago: a ring in block RAM, where registers would cost a logic cell a bit and clock.
module glint_delay #(
    parameter WIDTH = 16,
    parameter CLOCKS = 4  // 2..16
) (
    input clk,
    input rst,
    input en,
    input [WIDTH-1:0] d,
    output reg [WIDTH-1:0] q
);
    localparam [3:0] LAST = CLOCKS[3:0] - 4'd1;

    (* ram_style = "block" *) reg [WIDTH-1:0] ring[0:15];
    reg [3:0] place;
    // What is read is the oldest: written over a clock later.
    wire [3:0] next = place == LAST ? 4'd0 : place + 4'd1;

    always @(posedge clk)
        if (rst) place <= 0;
        else if (en) place <= next;

    always @(posedge clk)
        if (en) begin
            ring[place] <= d;
            q <= ring[next];
        end
endmodule
