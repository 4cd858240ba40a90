// SPDX-License-Identifier: MIT
// glint_product puts its product of 16 bits together to one of 17, in both forms. Partial products are free
// (test_span_handshake cuts them): low is a multiplier block's, at_0, at_5 and at_10 are rows' of 5, 5 and 6 bits.
`default_nettype none

module product (
    input wire clk,
    input wire [16:0] a,
    input wire [16:0] x
);
    wire [33:0] p;
    wire [31:0] low;
    wire [20:0] late_0, late_5;
    wire [21:0] late_10;
    glint_product dut (
        .clk(clk),
        .step(1'b1),
        .a(a),
        .x(x),
        .p(p),
        .low(low)
`ifdef PARTS
        ,
        .\rows.late_0 (late_0),
        .\rows.late_5 (late_5),
        .\rows.late_10 (late_10)
`endif
    );
    reg [16:0] a_before, x_before;
    reg begun = 0;
    always @(posedge clk) begin
        begun <= 1;
        a_before <= a;
        x_before <= x;
        if (begun) assume (a == a_before); // held still
        assume (a <= 65536 && x < 17'h1ffff);
`ifdef PARTS
        if (begun) assert ({2'd0, low} == {13'd0, late_0} + {8'd0, late_5, 5'd0} + {2'd0, late_10, 10'd0});
        assume (late_0 <= 31 * 65535 && late_5 <= 31 * 65535 && late_10 <= 63 * 65535);
`else
        // a x = (2^16 a16 + a') (2^16 x16 + x') = a' x' + 2^16 (x16 a' + a16 x), as a' = 0 where a16 = 1.
        assume (low <= 32'hfffe0001);
        if (a[15:0] == 0) assume (low == 0);
        if (begun)
            assert (p == {2'd0, low} + (x_before[16] ? {2'd0, a[15:0], 16'd0} : 34'd0) +
                (a[16] ? {1'd0, x_before, 16'd0} : 34'd0));
`endif
    end
endmodule

`default_nettype wire
