// SPDX-License-Identifier: MIT
// Any value: what test_span_handshake proves of glint_product is stated by the proof that uses this.
`default_nettype none

module glint_product #(
    parameter integer ROWS = 0,
    parameter integer ROW_AND = 0
) (
    input wire clk,
    input wire step,
    input wire [16:0] a,
    input wire [16:0] x,
    output wire [33:0] p
);
    assign p = $anyseq;
endmodule

`default_nettype wire
