// SPDX-License-Identifier: MIT
// p = a x for a = 0..65536, held still, one clock after x. Of the low 16 bits by a multiplier block, or with ROWS by
// rows of logic cells in three parts; the bits of 2^16 select and add.
`default_nettype none

module glint_product #(
    parameter integer ROWS = 0, // 0 or 1
    parameter integer ROW_AND = 0 // as in glint_row
) (
    input wire clk,
    input wire step,
    input wire [16:0] a,
    input wire [16:0] x,
    output wire [33:0] p
);
    wire [31:0] low;
    reg [16:0] x_late;
    always @(posedge clk) if (step) x_late <= x;

    generate
        if (ROWS != 0) begin : rows
            wire [20:0] at_0, at_5;
            wire [21:0] at_10;
            reg [20:0] late_0, late_5;
            reg [21:0] late_10;
            glint_rows #(.BITS(5), .ROW_AND(ROW_AND)) rows_0 (.a(a[4:0]), .x(x[15:0]), .product(at_0));
            glint_rows #(.BITS(5), .ROW_AND(ROW_AND)) rows_5 (.a(a[9:5]), .x(x[15:0]), .product(at_5));
            glint_rows #(.BITS(6), .ROW_AND(ROW_AND)) rows_10 (.a(a[15:10]), .x(x[15:0]), .product(at_10));
            always @(posedge clk)
                if (step) begin
                    late_0 <= at_0;
                    late_5 <= at_5;
                    late_10 <= at_10;
                end
            assign low = {11'b0, late_0} + {6'b0, late_5, 5'b0} + {late_10, 10'b0};
        end else begin : block
            reg [31:0] late;
            always @(posedge clk) if (step) late <= a[15:0] * x[15:0];
            assign low = late;
        end
    endgenerate

    wire [17:0] high = a[16] ? {1'b0, x_late} : {2'b0, low[31:16]} + (x_late[16] ? {2'b0, a[15:0]} : 18'b0);
    assign p = {high, low[15:0]}; // where a = 65536, low is 0
endmodule

`default_nettype wire
