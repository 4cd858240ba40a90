// SPDX-License-Identifier: MIT
// Written by firmware/gateware/registers/generate from registers.tsv.
// The registers of glint_span_wb: a write takes effect after the clock; what is read is there in the same clock.
`default_nettype none

module glint_registers (
    input wire clk,
    input wire rst,
    input wire write, // value into the register at address, of those that accept it
    input wire [4:0] address, // in words
    input wire [31:0] value,
    input wire [1:0] status,
    output reg [31:0] read,
    output wire of_shader, // what is at address
    output wire of_span,
    output wire pushes,
    output wire refused, // value is more than it may be
    output reg model,
    output reg [9:0] n,
    output reg [16:0] c_min,
    output reg clamp_peak,
    output reg [16:0] ambient_red,
    output reg [16:0] ambient_green,
    output reg [16:0] ambient_blue,
    output reg [16:0] diffuse_red,
    output reg [16:0] diffuse_green,
    output reg [16:0] diffuse_blue,
    output reg [16:0] specular_red,
    output reg [16:0] specular_green,
    output reg [16:0] specular_blue,
    output reg [31:0] t,
    output reg [31:0] dt,
    output reg [31:0] ddt,
    output reg [31:0] nl,
    output reg [31:0] dnl,
    output reg [12:0] w
);
    wire to_1 = value != 0;
    wire [9:0] to_1000 = value > 32'd1000 ? 10'd1000 : value[9:0];
    wire [16:0] to_65536 = value > 32'd65536 ? 17'd65536 : value[16:0];
    assign of_shader = address >= 5'd2 && address <= 5'd14;
    assign of_span = address >= 5'd15 && address <= 5'd20;
    assign pushes = address == 5'd20;
    assign refused = (address == 5'd20 && value > 32'd4096);
    always @(posedge clk) begin
        if (write && address == 5'd2) model <= to_1;
        if (write && address == 5'd3) n <= to_1000;
        if (write && address == 5'd4) c_min <= to_65536;
        if (write && address == 5'd5) clamp_peak <= to_1;
        if (write && address == 5'd6) ambient_red <= to_65536;
        if (write && address == 5'd7) ambient_green <= to_65536;
        if (write && address == 5'd8) ambient_blue <= to_65536;
        if (write && address == 5'd9) diffuse_red <= to_65536;
        if (write && address == 5'd10) diffuse_green <= to_65536;
        if (write && address == 5'd11) diffuse_blue <= to_65536;
        if (write && address == 5'd12) specular_red <= to_65536;
        if (write && address == 5'd13) specular_green <= to_65536;
        if (write && address == 5'd14) specular_blue <= to_65536;
        if (write && address == 5'd15) t <= value;
        if (write && address == 5'd16) dt <= value;
        if (write && address == 5'd17) ddt <= value;
        if (write && address == 5'd18) nl <= value;
        if (write && address == 5'd19) dnl <= value;
        if (write && address == 5'd20) w <= value[12:0];
        if (rst) begin
            model <= 0;
            n <= 0;
            c_min <= 0;
            clamp_peak <= 0;
            ambient_red <= 0;
            ambient_green <= 0;
            ambient_blue <= 0;
            diffuse_red <= 0;
            diffuse_green <= 0;
            diffuse_blue <= 0;
            specular_red <= 0;
            specular_green <= 0;
            specular_blue <= 0;
            t <= 0;
            dt <= 0;
            ddt <= 0;
            nl <= 0;
            dnl <= 0;
            w <= 0;
        end
    end
    always @*
        case (address)
            5'd0: read = 32'h676c696e;
            5'd1: read = {30'd0, status};
            5'd2: read = {31'd0, model};
            5'd3: read = {22'd0, n};
            5'd4: read = {15'd0, c_min};
            5'd5: read = {31'd0, clamp_peak};
            5'd6: read = {15'd0, ambient_red};
            5'd7: read = {15'd0, ambient_green};
            5'd8: read = {15'd0, ambient_blue};
            5'd9: read = {15'd0, diffuse_red};
            5'd10: read = {15'd0, diffuse_green};
            5'd11: read = {15'd0, diffuse_blue};
            5'd12: read = {15'd0, specular_red};
            5'd13: read = {15'd0, specular_green};
            5'd14: read = {15'd0, specular_blue};
            5'd15: read = t;
            5'd16: read = dt;
            5'd17: read = ddt;
            5'd18: read = nl;
            5'd19: read = dnl;
            5'd20: read = {19'd0, w};
            default: read = 0;
        endcase
endmodule

`default_nettype wire
