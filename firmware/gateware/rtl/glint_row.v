// SPDX-License-Identifier: MIT
// sum + more where add is set, else sum: a row of a product, one logic cell a bit. In a module of its own, which synthesis keeps, as
// mapping several rows at once takes half as many cells again.
(* keep_hierarchy *)
module glint_row #(
    parameter WIDTH = 13
) (
    input add,
    input [WIDTH-1:0] sum,
    input [WIDTH-1:0] more,
    output [WIDTH:0] result
);
    assign result = add ? {1'b0, sum} + {1'b0, more} : {1'b0, sum};
endmodule
