/* SPDX-License-Identifier: MIT
 * A dial of spun steel on a round GC9A01 panel whose lamp stays in its place while the hand tilts it, by an MPU-6050 or a QMI8658
 * on I2C, whichever answers (x to the right, y up). TFT_eSPI is
 * set up for the panel in its User_Setup.h (GC9A01_DRIVER, 240x240). A line at a time: no map, 2 KB of buffers. Nothing outside the circle is
 * drawn or sent, and a still hand sends nothing.
 *
 * Registers: MPU-6000/MPU-6050 Register Map, revision 4.2; QMI8658C data sheet 13-52-27, rev. A. */
#include <TFT_eSPI.h>
#include <Wire.h>
#include <glint.h>

enum { SIZE = 240, MOVES = 300 /* of 16384, 1 g: +-2 g */ };

/* The sensors: where it answers, who it says it is in a register, what is written to it, where its lowest bit says that a sample is new
 * (0: nowhere), and from where on x, y and z are read. */
struct sensor {
    uint8_t address, who, is, settings[3][2], status, first;
    bool low_first;
};
enum { MPU6050, QMI8658, QMI8658_OTHER, SENSORS };
static const struct sensor sensors[SENSORS] = {
    {0x68, 0x75, 0x68, {{0x6b, 0x00}, {0x1c, 0x00}, {0x1b, 0x00}}, 0, 0x3b, false}, /* it sleeps at first; +-2 g */
    {0x6b, 0x00, 0x05, {{0x02, 0x60}, {0x03, 0x05}, {0x08, 0x01}}, 0x2e, 0x35, true},  /* addresses count up; 250 Hz; on */
    {0x6a, 0x00, 0x05, {{0x02, 0x60}, {0x03, 0x05}, {0x08, 0x01}}, 0x2e, 0x35, true}};
static const struct sensor *sensor;

static TFT_eSPI tft;
static struct glint_paint paint;
static struct glint_maps maps;
static struct glint_vec normals[SIZE];
static uint16_t pixels[SIZE];
static int32_t mean_q3[3] = {0, 0, 8 * 16384L}, shown_q3[3];

static bool begin_read(uint8_t address, uint8_t from, uint8_t count)
{
    Wire.beginTransmission(address);
    Wire.write(from);
    return Wire.endTransmission(false) == 0 && Wire.requestFrom(address, count) == count;
}

/* The one that says who it is; else an MPU-6050, of which others by other names are made. */
static void find_sensor()
{
    sensor = &sensors[MPU6050];
    for (int i = 0; i < SENSORS; i++)
        if (begin_read(sensors[i].address, sensors[i].who, 1) && (Wire.read() & 255) == sensors[i].is)
            sensor = &sensors[i];
    for (int i = 0; i < 3; i++) {
        Wire.beginTransmission(sensor->address);
        Wire.write(sensor->settings[i][0]);
        Wire.write(sensor->settings[i][1]);
        Wire.endTransmission();
    }
}

/* Of a read that meets the next sample a QMI8658's bytes may be of both, so it waits for a new one: 4 ms. One that never says so is
 * read all the same. An MPU-6050 keeps its bytes together. */
static void wait_for_sample()
{
    for (int looks = 0; sensor->status && looks < 8; looks++) {
        if (begin_read(sensor->address, sensor->status, 1) && (Wire.read() & 1))
            return;
        delayMicroseconds(500);
    }
}

/* What a sensor at rest gives is 1 g upwards. False: it does not answer, or has no sample yet. */
static bool read_sensor(int16_t sample[3])
{
    int16_t read[3];
    wait_for_sample();
    if (!begin_read(sensor->address, sensor->first, 6))
        return false;
    for (int i = 0; i < 3; i++) {
        const unsigned one = (unsigned)Wire.read() & 255, other = (unsigned)Wire.read() & 255;
        read[i] = (int16_t)(uint16_t)(sensor->low_first ? other << 8 | one : one << 8 | other);
    }
    if (!(read[0] | read[1] | read[2]))
        return false;
    for (int i = 0; i < 3; i++)
        sample[i] = read[i];
    return true;
}

static void draw_line(int y)
{
    const int32_t up = SIZE - 1 - 2 * y, face = 200; /* half pixels */
    int32_t first = 0;
    while ((2 * first + 1 - SIZE) * (2 * first + 1 - SIZE) + up * up > SIZE * SIZE)
        first++;
    const uint16_t count = (uint16_t)(SIZE - 2 * first);
    for (int32_t i = 0; i < count; i++) {
        const int32_t right = 2 * (first + i) + 1 - SIZE, square = right * right + up * up;
        const int32_t bend = square > face * face ? square - face * face : 0; /* the rim */
        const int32_t slope[3] = {right * bend / 64, up * bend / 64, 40000};
        glint_vec_normalize(&normals[i], slope);
    }
    const struct glint_surface line = {pixels, sizeof pixels, (uint16_t)first, (uint16_t)y};
    glint_draw_rect(&paint, &maps, count, 1, &line, NULL);
    tft.pushImage(first, y, count, 1, pixels);
}

void setup()
{
    /* model, q, n, n_across, ambient, diffuse, specular, albedo, clamp_peak */
    static const struct glint_material steel = {
        GLINT_MSH, 0, 4, 160, {9000, 9000, 9500}, {20000, 20000, 21000}, {52000, 52000, 54000}, {160, 162, 168}, false};
    static const struct glint_output output = {GLINT_RGB565_SWAPPED, GLINT_GAMMA, false};
    tft.init();
    tft.fillScreen(TFT_BLACK);
    tft.setSwapBytes(false);
    Wire.begin();
    find_sensor();
    maps.normals = normals;
    maps.grain_kind = GLINT_GRAIN_SPUN;
    maps.grain_at[0] = maps.grain_at[1] = 16 * SIZE / 2;
    glint_paint_exact_for(&paint, &steel, &output, &glint_use_msh_grain, &glint_use_rgb565);
}

void loop()
{
    static const int32_t to_viewer[3] = {0, 0, 1};
    int16_t sample[3] = {0, 0, 16384};
    int32_t moved = 0;
    read_sensor(sample); /* without a sensor it lies flat */
    for (int i = 0; i < 3; i++) {
        mean_q3[i] += sample[i] - mean_q3[i] / 8;
        const int32_t by = mean_q3[i] - shown_q3[i];
        moved = by > moved ? by : -by > moved ? -by : moved;
    }
    if (moved < 8 * MOVES)
        return;
    for (int i = 0; i < 3; i++)
        shown_q3[i] = mean_q3[i];
    /* The lamp is above, a little to the left and behind: straight above a dial that lies flat all of its face would shine. */
    const int32_t to_light[3] = {shown_q3[0] - 32768, shown_q3[1] + 49152, shown_q3[2] < 32768 ? 32768 : shown_q3[2]};
    struct glint_light light;
    glint_light_directional(&light, to_light);
    glint_paint_light(&paint, &light, 1, to_viewer);
    for (int y = 0; y < SIZE; y++)
        draw_line(y);
}
