// SPDX-License-Identifier: MIT
// For yosys' techmap: registers become wires, and carries ripple, which takes the fewest gates.
`default_nettype none

module \$_DFF_P_ (
    input wire C,
    input wire D,
    output wire Q
);
    assign Q = D;
endmodule

module \$_DFFE_PP_ (
    input wire C,
    input wire E,
    input wire D,
    output wire Q
);
    assign Q = D;
endmodule

module \$lcu #(
    parameter integer WIDTH = 1
) (
    input wire [WIDTH-1:0] P,
    input wire [WIDTH-1:0] G,
    input wire CI,
    output wire [WIDTH-1:0] CO
);
    genvar i;
    generate
        for (i = 0; i < WIDTH; i = i + 1) begin : bits
            if (i == 0) assign CO[i] = G[i] | (P[i] & CI);
            else assign CO[i] = G[i] | (P[i] & CO[i-1]);
        end
    endgenerate
endmodule

`default_nettype wire
