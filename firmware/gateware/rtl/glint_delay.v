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
    localparam [31:0] LAST = CLOCKS - 1;

    (* ram_style = "block" *) reg [WIDTH-1:0] ring[0:15];
    reg [3:0] place;
    // What is read is the oldest: written over a clock later. (Counted bit by bit: a carry chain would take more cells.)
    wire [3:0] after = place ^ {&place[2:0], &place[1:0], place[0], 1'b1};
    wire [3:0] next = place == LAST[3:0] ? 4'd0 : after;

    always @(posedge clk)
        if (rst) place <= 0;
        else if (en) place <= next;

    always @(posedge clk)
        if (en) begin
            ring[place] <= d;
            q <= ring[next];
        end

    wire unused = &{1'b0, LAST[31:4]};
endmodule
