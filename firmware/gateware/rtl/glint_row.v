// SPDX-License-Identifier: MIT
// sum + more where add is set, else sum: a row of a product, one logic cell a bit. In a module of its own, which
// synthesis keeps, as mapping several rows at once takes half as many cells again.
`default_nettype none

(* keep_hierarchy *)
module glint_row #(
    parameter integer WIDTH = 13,
    parameter integer ROW_AND = 0 // 1: in the form that fits carry chains with a table before each input (Xilinx)
) (
    input wire add,
    input wire [WIDTH-1:0] sum,
    input wire [WIDTH-1:0] more,
    output wire [WIDTH:0] result
);
    generate
        if (ROW_AND != 0) begin : masked
            assign result = {1'b0, sum} + {1'b0, more & {WIDTH{add}}};
        end else begin : chosen
            assign result = add ? {1'b0, sum} + {1'b0, more} : {1'b0, sum};
        end
    endgenerate
endmodule

`default_nettype wire
