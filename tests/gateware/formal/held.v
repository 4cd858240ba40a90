// SPDX-License-Identifier: MIT
// What is offered stays as it is until it is taken; nothing is offered right after a reset.
`default_nettype none

module held #(
    parameter integer WIDTH = 1
) (
    input wire clk,
    input wire rst,
    input wire valid,
    input wire ready,
    input wire [WIDTH-1:0] data
);
    reg begun = 0, was_reset, was_waiting;
    reg [WIDTH-1:0] before;
    always @(posedge clk) begin
        begun <= 1;
        was_reset <= rst;
        was_waiting <= valid & !ready & !rst;
        before <= data;
        if (!begun) assume (rst);
        if (begun & was_reset) assert (!valid);
        if (begun & was_waiting) assert (valid & data == before);
    end
endmodule

`default_nettype wire
