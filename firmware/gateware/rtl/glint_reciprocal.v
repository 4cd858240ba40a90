// SPDX-License-Identifier: MIT
// z, nearly 2^18 times 1.6 / x^2 (modified Schlick) or 1 / x (Schlick), for x = y / 2^27, 1 <= x < 2: a line through each of
// 256 intervals, half way between chord and tangent. Two clocks after y.
module glint_reciprocal (
    input clk,
    input en,
    input model,
    input [26:8] y,  // without the leading 1
    output reg [18:0] z
);
    // 2^36 times the function at k / 512.
    function [63:0] f(input schlick, input [63:0] k);
        f = schlick ? (64'd1 << 45) / k : ((64'd8 << 54) / 5) / (k * k);
    endfunction

    // The line's height at the interval's right end, where it is lowest, in 2^-18. It is raised by what cutting products and
    // places short costs in the mean.
    function [18:0] base(input schlick, input [63:0] i);
        /* verilator lint_off UNUSEDSIGNAL */
        reg [63:0] sum;
        /* verilator lint_on UNUSEDSIGNAL */
        begin
            sum = 3 * f(schlick, 514 + 2 * i) + 2 * f(schlick, 513 + 2 * i) - f(schlick, 512 + 2 * i);
            sum = (sum + (schlick ? 64'd24 << 16 : 64'd29 << 16)) >> 20;
            base = sum[18:0];
        end
    endfunction

    // Its rise over the interval, in 2^-19.
    function [12:0] slope(input schlick, input [63:0] i);
        /* verilator lint_off UNUSEDSIGNAL */
        reg [63:0] rise;
        /* verilator lint_on UNUSEDSIGNAL */
        begin
            rise = (f(schlick, 512 + 2 * i) - f(schlick, 514 + 2 * i) + (64'd1 << 16)) >> 17;
            slope = rise[12:0];
        end
    endfunction

    reg [31:0] lines[0:511];
    integer i;
    initial for (i = 0; i < 512; i = i + 1) lines[i] = {base(i >= 256, {56'd0, i[7:0]}), slope(i >= 256, {56'd0, i[7:0]})};

    reg [31:0] line;
    reg [10:0] back;  // from the right end
    wire [23:0] rise = {11'd0, line[12:0]} * {13'd0, back};
    always @(posedge clk)
        if (en) begin
            line <= lines[{model, y[26:19]}];
            back <= ~y[18:8];
            z <= line[31:13] + {7'd0, rise[23:12]};
        end

    wire unused = &{1'b0, rise[11:0]};
endmodule
