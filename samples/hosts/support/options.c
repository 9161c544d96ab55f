#include "samples/hosts/support/options.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

int read_steps(const char* text, uint64_t* steps) {
    char* end;
    if (*text < '0' || *text > '9') return 0; /* strtoull() takes a sign */
    errno = 0;
    *steps = strtoull(text, &end, 10);
    return *steps > 0 && !*end && errno == 0;
}

int read_size(const char* text, unsigned* width, unsigned* height) {
    int length = 0;
    if (sscanf(text, "%5u%*1[x]%5u%n", width, height, &length) != 2 || text[length]) return 0;
    return *width - 1 < 4096 && *height - 1 < 4096;
}

int is_path(const char* text) {
    return *text && *text != '-';
}

int make_folder(const char* path) {
    char part[4096];
    const size_t length = strlen(path);
    size_t i;
    struct stat made;
    if (length >= sizeof part) return 0;
    for (i = 1; i <= length; ++i) {
        if (path[i] && path[i] != '/') continue;
        memcpy(part, path, i);
        part[i] = 0;
        if (mkdir(part, 0777) != 0 && errno != EEXIST) return 0;
    }
    return stat(path, &made) == 0 && S_ISDIR(made.st_mode);
}
