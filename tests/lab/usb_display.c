/* SPDX-License-Identifier: MIT */
#include "unit.h"

#include <endian.h>
#include <errno.h>
#include <linux/usb/functionfs.h>
#include <lz4.h>
#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "gud_protocol.h"
#include "usb_display.h"
#include "usb_function.h"

void usb_display_defaults(struct usb_display_config *c, uint16_t width, uint16_t height)
{
    static const uint8_t formats[] = {GUD_RGB565, GUD_RGB888, GUD_XRGB8888, GUD_R8, GUD_R1};
    *c = (struct usb_display_config){.ids = {.vendor = 0x1209, .product = 1, .serial = "lab"}, .status = GUD_CONNECTED};
    gud_descriptor_pack(c->descriptor, &(struct gud_descriptor){.compression = GUD_COMPRESSION_LZ4,
                                                                .min_width = width,
                                                                .max_width = width,
                                                                .min_height = height,
                                                                .max_height = height});
    gud_mode_pack(c->modes, &(struct gud_mode){.hdisplay = width,
                                               .hsync_start = width,
                                               .hsync_end = width,
                                               .htotal = width,
                                               .vdisplay = height,
                                               .vsync_start = height,
                                               .vsync_end = height,
                                               .vtotal = height,
                                               .clock_khz = width * height * 60u / 1000u,
                                               .flags = GUD_MODE_PREFERRED});
    memcpy(c->formats, formats, sizeof formats);
    c->formats_bytes = sizeof formats;
    c->descriptor_bytes = GUD_DESCRIPTOR_BYTES;
    c->connectors_bytes = GUD_CONNECTOR_BYTES;
    c->status_bytes = 1;
    c->modes_bytes = GUD_MODE_BYTES;
}

struct process {
    const struct usb_display_config *config;
    struct usb_display *display;
    struct usb_function function;
    pthread_t reader;
    pthread_mutex_t mutex;
    pthread_cond_t cond;
    struct gud_rectangle rectangle; /* what bulk data is for; width 0: none */
    volatile unsigned generation;   /* changes with each */
    volatile bool reading;
    uint8_t status, *data;
    unsigned troubled; /* the change of config whose trouble is over */
};

/* ---- bulk data ---- */

static void draw(struct process *p, const struct gud_rectangle *r, const uint8_t *data)
{
    const enum gud_format format = (enum gud_format)p->display->seen->format;
    static uint8_t unpacked[USB_PICTURE_MAX];
    const size_t line = gud_line_bytes(format, r->width), pitch = gud_line_bytes(format, p->display->seen->width);
    bool good = r->length == line * r->height && r->x + r->width <= p->display->seen->width &&
                r->y + r->height <= p->display->seen->height && (format != GUD_R1 || r->x % 8 == 0);
    if (good && r->compression) {
        good = LZ4_decompress_safe((const char *)data, (char *)unpacked, (int)r->compressed_length, (int)r->length) ==
               (int)r->length;
        data = unpacked;
        p->display->seen->compressed++;
    }
    if (!good) {
        p->display->seen->protocol_errors++;
        return;
    }
    for (uint32_t y = 0; y < r->height; y++)
        memcpy(&p->display->seen->picture[(r->y + y) * pitch + gud_line_bytes(format, r->x)], &data[y * line], line);
    p->display->seen->rectangles++;
}

static bool now_troubled(struct process *p, size_t bytes)
{
    const struct usb_display_config *c = p->config;
    if ((c->trouble != BULK_NAK && c->trouble != BULK_STALL && c->trouble != UNPLUG) ||
        p->troubled == p->display->seen->changes)
        return false;
    return p->display->seen->bulk_bytes + bytes > c->trouble_at;
}

/* True where the data that comes now is lost. */
static bool make_trouble(struct process *p, unsigned generation)
{
    if (!p->config->trouble_lasts)
        p->troubled = p->display->seen->changes;
    switch (p->config->trouble) {
    case BULK_NAK:
        while (generation == p->generation && p->config->trouble == BULK_NAK)
            usleep(10000);
        return true;
    case BULK_STALL: /* what is wrong way round halts the endpoint */
        if (write(p->function.bulk, p->data, 1) >= 0 || errno != EBADMSG)
            perror("usb_display: halt");
        return true;
    case UNPLUG:
        usb_function_unplug(&p->function);
        p->generation++;
        if (p->config->trouble_ms) {
            usleep(p->config->trouble_ms * 1000);
            usb_function_plug(&p->function, p->config->controller);
        }
        return true;
    default:
        return false;
    }
}

/* Whole frames come without announcement where that was asked for. */
static bool announced(struct process *p)
{
    if (!(p->config->descriptor[5] & GUD_FLAG_FULL_UPDATE) || !p->display->seen->display)
        return false;
    const uint16_t width = p->display->seen->width, height = p->display->seen->height;
    const size_t bytes = gud_line_bytes((enum gud_format)p->display->seen->format, width) * height;
    p->rectangle = (struct gud_rectangle){0, 0, width, height, (uint32_t)bytes, 0, 0};
    return true;
}

static void *read_bulk(void *argument)
{
    struct process *p = argument;
    p->data = malloc(USB_PICTURE_MAX);
    for (;;) {
        pthread_mutex_lock(&p->mutex);
        while (!p->rectangle.width && !announced(p))
            pthread_cond_wait(&p->cond, &p->mutex);
        const struct gud_rectangle r = p->rectangle;
        const unsigned generation = p->generation;
        p->rectangle.width = 0;
        p->reading = true;
        pthread_mutex_unlock(&p->mutex);
        const size_t bytes = r.compression ? r.compressed_length : r.length;
        size_t got = 0;
        bool lost = bytes > USB_PICTURE_MAX;
        while (got < bytes && !lost && generation == p->generation) {
            const size_t left = bytes - got;
            if (now_troubled(p, left < 16384 ? left : 16384)) {
                lost = make_trouble(p, generation);
                continue;
            }
            const ssize_t count = read(p->function.bulk, p->data + got, left < 16384 ? left : 16384);
            if (count < 0)
                break;
            got += (size_t)count;
            p->display->seen->bulk_bytes += (size_t)count;
        }
        if (got == bytes)
            draw(p, &r, p->data);
        p->reading = false;
    }
    return NULL;
}

/* ---- control requests ---- */

static void stall(struct process *p, bool in, uint8_t status)
{
    p->status = status;
    /* What is wrong way round is a stall. */
    if ((in ? read(p->function.ep0, NULL, 0) : write(p->function.ep0, NULL, 0)) >= 0 || errno != EL2HLT)
        perror("usb_display: stall");
}

static void set_state(struct process *p, const uint8_t *data)
{
    struct gud_mode mode;
    gud_mode_unpack(&mode, data);
    p->display->seen->width = mode.hdisplay;
    p->display->seen->height = mode.vdisplay;
    p->display->seen->format = data[GUD_MODE_BYTES];
}

/* With the mutex held: what no longer comes is not waited for. */
static void stop_reading(struct process *p)
{
    p->generation++;
    while (p->reading) {
        pthread_mutex_unlock(&p->mutex);
        pthread_kill(p->reader, SIGUSR1);
        usleep(1000);
        pthread_mutex_lock(&p->mutex);
    }
}

static void set_display(struct process *p, bool on)
{
    pthread_mutex_lock(&p->mutex);
    p->display->seen->display = on;
    if (on)
        pthread_cond_signal(&p->cond);
    else
        stop_reading(p);
    pthread_mutex_unlock(&p->mutex);
}

static void set_buffer(struct process *p, const uint8_t *data)
{
    pthread_mutex_lock(&p->mutex);
    stop_reading(p);
    gud_rectangle_unpack(&p->rectangle, data);
    pthread_cond_signal(&p->cond);
    pthread_mutex_unlock(&p->mutex);
}

static void take(struct process *p, uint8_t request, const uint8_t *data, uint16_t bytes)
{
    p->status = GUD_OK;
    if (request == GUD_SET_STATE_CHECK && bytes >= GUD_STATE_BYTES)
        set_state(p, data);
    else if (request == GUD_SET_BUFFER && bytes == GUD_RECTANGLE_BYTES)
        set_buffer(p, data);
    else if (request == GUD_SET_CONTROLLER_ENABLE && bytes == 1)
        p->display->seen->controller = data[0];
    else if (request == GUD_SET_DISPLAY_ENABLE && bytes == 1)
        set_display(p, data[0]);
    else if (request != GUD_SET_STATE_COMMIT && request != GUD_SET_CONNECTOR_FORCE_DETECT)
        p->display->seen->protocol_errors++;
}

static void answer(struct process *p, uint8_t request, uint16_t length)
{
    const struct usb_display_config *c = p->config;
    const struct {
        uint8_t request;
        const uint8_t *data;
        uint16_t bytes;
    } answers[] = {{GUD_GET_STATUS, &p->status, 1},
                   {GUD_GET_DESCRIPTOR, c->descriptor, c->descriptor_bytes},
                   {GUD_GET_FORMATS, c->formats, c->formats_bytes},
                   {GUD_GET_PROPERTIES, NULL, 0},
                   {GUD_GET_CONNECTORS, c->connectors, c->connectors_bytes},
                   {GUD_GET_CONNECTOR_PROPERTIES, NULL, 0},
                   {GUD_GET_CONNECTOR_STATUS, &c->status, c->status_bytes},
                   {GUD_GET_CONNECTOR_MODES, c->modes, c->modes_bytes},
                   {GUD_GET_CONNECTOR_EDID, NULL, 0}};
    for (size_t i = 0; i < sizeof answers / sizeof *answers; i++) {
        if (answers[i].request != request)
            continue;
        if (write(p->function.ep0, answers[i].data ? answers[i].data : (const uint8_t *)"",
                  answers[i].bytes < length ? answers[i].bytes : length) < 0 &&
            c->trouble != CONTROL_SILENT) /* then the host no longer waits */
            perror("usb_display: answer");
        return;
    }
    stall(p, true, GUD_UNSUPPORTED);
}

static void setup(struct process *p, const struct usb_ctrlrequest *request)
{
    const bool in = request->bRequestType & USB_DIR_IN;
    const uint16_t length = le16toh(request->wLength);
    const struct usb_display_config *c = p->config;
    uint8_t data[4096] = {0};
    if (p->display->seen->request_count < USB_REQUESTS_MAX)
        p->display->seen->requests[p->display->seen->request_count] = request->bRequest;
    p->display->seen->request_count++;
    if ((c->trouble == CONTROL_STALL || c->trouble == CONTROL_SILENT) && request->bRequest == c->trouble_request &&
        p->troubled != p->display->seen->changes) {
        if (!c->trouble_lasts)
            p->troubled = p->display->seen->changes;
        if (c->trouble == CONTROL_STALL) {
            stall(p, in, c->trouble_status);
            return;
        }
        p->display->seen->silent = true;
        usleep(c->trouble_ms * 1000);
        p->display->seen->silent = false;
    }
    if (in)
        answer(p, request->bRequest, length);
    else if (request->bRequest == GUD_SET_BUFFER && !p->display->seen->controller) /* it was reset */
        stall(p, in, GUD_PARAMETER);
    else if (length > sizeof data || read(p->function.ep0, data, length) != length)
        p->display->seen->protocol_errors++;
    else
        take(p, request->bRequest, data, length);
}

static void on_wake(int number)
{
    (void)number;
}

static _Noreturn void serve(struct process *p)
{
    usb_function_build(&p->function, p->display->name, &p->config->ids);
    sigaction(SIGUSR1, &(struct sigaction){.sa_handler = on_wake}, NULL);
    pthread_create(&p->reader, NULL, read_bulk, p);
    usb_function_plug(&p->function, p->config->controller);
    for (;;) {
        struct usb_functionfs_event event;
        /* Until Linux 6.1.176 a read that waits keeps the lock that unplugging asks for. */
        poll(&(struct pollfd){.fd = p->function.ep0, .events = POLLIN}, 1, -1);
        if (read(p->function.ep0, &event, sizeof event) != sizeof event) {
            if (errno == EAGAIN || errno == EINTR || errno == EL2HLT || errno == EIDRM)
                continue;
            perror("usb_display: ep0");
            _exit(1);
        }
        if (event.type == FUNCTIONFS_SETUP) {
            setup(p, &event.u.setup);
        } else if (event.type == FUNCTIONFS_ENABLE || event.type == FUNCTIONFS_DISABLE) {
            /* After a bus reset only the last is told: all that the host had set is gone. */
            p->display->seen->ready = event.type == FUNCTIONFS_ENABLE;
            p->display->seen->starts += event.type == FUNCTIONFS_ENABLE;
            p->display->seen->controller = p->display->seen->display = false;
            p->generation++;
        }
    }
}

/* ---- for the test ---- */

enum { DISPLAYS_MAX = 4 };
static struct usb_display *displays[DISPLAYS_MAX];

static void plug_new(struct usb_display *display, const struct usb_display_config *config)
{
    static unsigned number;
    unsigned place = 0;
    while (displays[place])
        assert_true(++place < DISPLAYS_MAX);
    displays[place] = display;
    snprintf(display->name, sizeof display->name, "display%u", number++);
    display->seen = mmap(NULL, sizeof *display->seen, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    assert_true(display->seen != MAP_FAILED);
    display->seen->config = *config;
    display->seen->changes = 1;
    fflush(NULL);
    display->process = fork();
    assert_true(display->process >= 0);
    if (display->process == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        struct process process = {.config = &display->seen->config,
                                  .display = display,
                                  .mutex = PTHREAD_MUTEX_INITIALIZER,
                                  .cond = PTHREAD_COND_INITIALIZER};
        serve(&process);
    }
}

void usb_display_be(struct usb_display *display, const struct usb_display_config *config)
{
    if (display->process == 0) {
        plug_new(display, config);
    } else {
        assert_soon(!display->seen->silent);
        display->seen->config = *config;
        display->seen->changes++;
        display->seen->request_count = display->seen->bulk_bytes = display->seen->rectangles = 0;
        display->seen->compressed = display->seen->protocol_errors = 0;
        memset(display->seen->picture, 0x5a, sizeof display->seen->picture);
    }
    assert_soon(display->seen->ready);
    display->seen->starts = 0;
}

void usb_display_unplug(struct usb_display *display)
{
    for (unsigned i = 0; i < DISPLAYS_MAX; i++)
        if (displays[i] == display)
            displays[i] = NULL;
    kill(display->process, SIGKILL);
    waitpid(display->process, NULL, 0);
    usb_function_remove(display->name);
    munmap(display->seen, sizeof *display->seen);
    display->process = 0;
}

int usb_displays_unplug(void **state)
{
    (void)state;
    for (unsigned i = 0; i < DISPLAYS_MAX; i++)
        if (displays[i])
            usb_display_unplug(displays[i]);
    return 0;
}
