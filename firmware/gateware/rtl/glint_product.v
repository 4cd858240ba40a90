// SPDX-License-Identifier: MIT
// p = a x for a = 0..65536, held still, one clock after x. One 16x16 multiplier: the bits of 2^16 select and add.
module glint_product (
    input clk,
    input step,
    input [16:0] a,
    input [16:0] x,
    output [33:0] p
);
    reg [31:0] low;
    reg [16:0] x_late;
    always @(posedge clk)
        if (step) begin
            low <= a[15:0] * x[15:0];
            x_late <= x;
        end
    wire [17:0] high = a[16] ? {1'b0, x_late} : {2'b0, low[31:16]} + (x_late[16] ? {2'b0, a[15:0]} : 18'b0);
    assign p = {high, low[15:0]}; // where a = 65536, low is 0
endmodule
