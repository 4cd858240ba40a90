/* SPDX-License-Identifier: MIT
 * The gadget in configfs, and the FunctionFS mount that goes with it. */
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <unistd.h>

#include "configfs.h"
#include "message.h"

#define CONFIGFS "/sys/kernel/config"
#define GADGETS CONFIGFS "/usb_gadget"
enum { NAME_ROOM = 512 };

static char gadget[NAME_ROOM / 2], mounted[NAME_ROOM / 2], controller[256], instance[64];
static bool created, is_mounted, plugged; /* plugged: as wanted */

static void path_of(char path[NAME_ROOM], const char *entry)
{
    snprintf(path, NAME_ROOM, "%s/%s", gadget, entry);
}

static bool put(const char *entry, const char *text)
{
    char path[NAME_ROOM];
    path_of(path, entry);
    const int file = open(path, O_WRONLY);
    if (file < 0)
        return false;
    const ssize_t written = write(file, text, strlen(text));
    const int error = errno;
    close(file);
    errno = error;
    return written == (ssize_t)strlen(text);
}

static void must_put(const char *entry, const char *text)
{
    if (!put(entry, text))
        fail("%s/%s: '%s' is refused: %s", gadget, entry, text, strerror(errno));
}

static void must_make(const char *entry)
{
    char path[NAME_ROOM];
    path_of(path, entry);
    if (mkdir(path, 0755) != 0 && errno != EEXIST)
        fail("%s: %s%s", path, strerror(errno),
             strstr(entry, "functions/") ? "; the kernel needs CONFIG_USB_CONFIGFS_F_FS" : "");
}

static bool get(const char *entry, char *text, size_t room)
{
    char path[NAME_ROOM];
    path_of(path, entry);
    FILE *file = fopen(path, "re");
    if (!file)
        return false;
    const bool good = fgets(text, (int)room, file) != NULL;
    fclose(file);
    if (good)
        text[strcspn(text, "\n")] = 0;
    return good && *text;
}

/* Everything of a gadget, there or not: at last the function, by which it is known as ours. */
static void take_down(void)
{
    static const char *const folders[] = {"configs/c.1/strings/0x409", "configs/c.1", "strings/0x409", NULL, ""};
    char path[NAME_ROOM], entry[NAME_ROOM / 2];
    if (is_mounted)
        umount2(mounted, MNT_DETACH);
    is_mounted = false;
    rmdir(mounted);
    snprintf(entry, sizeof entry, "configs/c.1/%s", instance);
    path_of(path, entry);
    unlink(path);
    for (unsigned i = 0; i < sizeof folders / sizeof *folders; i++) {
        snprintf(entry, sizeof entry, "functions/%s", instance);
        path_of(path, folders[i] ? folders[i] : entry);
        rmdir(path);
    }
}

static bool is_in_use(const char *udc)
{
    DIR *gadgets = opendir(GADGETS);
    bool used = false;
    for (const struct dirent *entry; !used && gadgets && (entry = readdir(gadgets));) {
        if (entry->d_name[0] == '.')
            continue;
        char path[NAME_ROOM + sizeof entry->d_name], name[NAME_ROOM] = "";
        snprintf(path, sizeof path, GADGETS "/%s/UDC", entry->d_name);
        FILE *file = fopen(path, "re");
        if (file && fgets(name, sizeof name, file))
            name[strcspn(name, "\n")] = 0;
        if (file)
            fclose(file);
        used = strcmp(name, udc) == 0;
    }
    if (gadgets)
        closedir(gadgets);
    return used;
}

static void find_controller(const char *wanted)
{
    DIR *udcs = opendir("/sys/class/udc");
    unsigned there = 0;
    for (const struct dirent *entry; udcs && (entry = readdir(udcs));) {
        if (entry->d_name[0] == '.' || (wanted && strcmp(wanted, entry->d_name) != 0))
            continue;
        there++;
        if (!is_in_use(entry->d_name) && (!*controller || strcmp(entry->d_name, controller) < 0))
            snprintf(controller, sizeof controller, "%s", entry->d_name);
    }
    if (udcs)
        closedir(udcs);
    if (*controller)
        return;
    if (there)
        fail("%s: in use by another gadget; free it, or name another by --udc",
             wanted ? wanted : "every USB device controller");
    if (wanted)
        fail("--udc: there is no USB device controller '%s' in /sys/class/udc", wanted);
    fail("there is no USB device controller: /sys/class/udc is empty; the board's USB port must be in device mode");
}

static const char *remedy(int error)
{
    switch (error) {
    case EPERM:
    case EACCES:
        return "; run it as root";
    case ENOENT:
    case ENODEV:
        return "; load libcomposite (modprobe libcomposite): the kernel needs CONFIG_USB_CONFIGFS_F_FS";
    case EEXIST:
        return "; it is not this program's: give another --name";
    default:
        return "";
    }
}

static void mount_configfs(void)
{
    if (access(GADGETS, F_OK) == 0)
        return;
    if (mount("none", CONFIGFS, "configfs", 0, NULL) != 0 && errno != EBUSY)
        fail(CONFIGFS ": cannot be mounted: %s%s", strerror(errno), remedy(errno));
    if (access(GADGETS, F_OK) != 0)
        fail(GADGETS ": not there; load libcomposite (modprobe libcomposite)");
}

static void describe(const struct options *options)
{
    char text[16];
    snprintf(text, sizeof text, "0x%04x", options->vid_pid >> 16);
    must_put("idVendor", text);
    snprintf(text, sizeof text, "0x%04x", options->vid_pid & 0xffff);
    must_put("idProduct", text);
    if (options->speed)
        must_put("max_speed", options->speed);
    must_make("strings/0x409");
    must_put("strings/0x409/manufacturer", "glint");
    must_put("strings/0x409/product", "glint display");
    if (*options->serial)
        must_put("strings/0x409/serialnumber", options->serial);
    must_make("configs/c.1");
    must_make("configs/c.1/strings/0x409");
    must_put("configs/c.1/strings/0x409/configuration", "display");
}

static void make_function(void)
{
    char entry[NAME_ROOM / 2];
    snprintf(entry, sizeof entry, "functions/%s", instance);
    must_make(entry);
}

static bool has_function(void)
{
    char entry[NAME_ROOM / 2], path[NAME_ROOM];
    snprintf(entry, sizeof entry, "functions/%s", instance);
    path_of(path, entry);
    return access(path, F_OK) == 0;
}

static void mount_function(const struct options *options)
{
    char function[NAME_ROOM], link[NAME_ROOM], entry[NAME_ROOM / 2];
    snprintf(entry, sizeof entry, "functions/%s", instance);
    path_of(function, entry);
    snprintf(entry, sizeof entry, "configs/c.1/%s", instance);
    path_of(link, entry);
    if (symlink(function, link) != 0)
        fail("%s: %s", link, strerror(errno));
    if ((mkdir(mounted, 0700) != 0 && errno != EEXIST) || mount(options->name, mounted, "functionfs", 0, NULL) != 0)
        fail("%s: cannot be mounted: %s", mounted, strerror(errno));
    is_mounted = true;
}

static bool is_bound(void)
{
    char text[NAME_ROOM];
    return get("UDC", text, sizeof text);
}

const char *configfs_create(const struct options *options)
{
    mount_configfs();
    snprintf(gadget, sizeof gadget, GADGETS "/%s", options->name);
    snprintf(instance, sizeof instance, "ffs.%s", options->name);
    snprintf(mounted, sizeof mounted, "/dev/ffs-%s", options->name);
    if (is_bound())
        fail("%s: in use by another program; end it, or give another --name", gadget);
    /* Without a function it is ours only where nothing at all is in it, as between two steps of one that was killed. */
    if (access(gadget, F_OK) == 0 && !has_function() && rmdir(gadget) != 0)
        fail("%s: %s%s", gadget, strerror(EEXIST), remedy(EEXIST));
    find_controller(options->udc);
    if (has_function()) { /* of one that was killed */
        is_mounted = true;
        take_down();
    }
    if (mkdir(gadget, 0755) != 0)
        fail("%s: %s%s", gadget, strerror(errno), remedy(errno));
    created = true;
    atexit(configfs_remove);
    make_function(); /* at once: by it the next run knows the gadget as ours */
    describe(options);
    mount_function(options);
    return mounted;
}

void configfs_remove(void)
{
    if (!created)
        return;
    created = false;
    configfs_unplug();
    take_down();
}

bool configfs_plug(void)
{
    plugged = true;
    return put("UDC", controller);
}

bool configfs_unplug(void)
{
    plugged = false;
    return put("UDC", "\n");
}

bool configfs_is_lost(void)
{
    return plugged && !is_bound();
}

const char *configfs_udc(void)
{
    return controller;
}
