// SPDX-License-Identifier: MIT
// What the quotient is multiplied by to be compared with the cosine: 5 y^2 / 2^30 (modified Schlick) or y (Schlick), in
// units of 2^-8. Two clocks.
module glint_divisor (
    input clk,
    input en,
    input model,
    input [27:0] y,
    output reg [36:0] s
);
    reg [35:0] x;
    wire [55:0] square = {28'd0, y} * {28'd0, y};
    always @(posedge clk)
        if (en) begin
            x <= model ? {y, 8'd0} : {2'd0, square[55:22]};
            s <= model ? {1'b0, x} : {1'b0, x} + {x[34:0], 2'd0};
        end

    wire unused = &{1'b0, square[21:0]};
endmodule
