/* What a host can say of a run: its memory, an image. */
#ifndef RUBBLE_HOSTS_REPORT_H
#define RUBBLE_HOSTS_REPORT_H
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Memory of this process in KiB, as the system counts it (resident). */
uint64_t resident_kib(void);

/* Writes pixels as PNG: three bytes each, rows from the bottom, as glReadPixels() gives them. 0: it cannot. */
int write_png(const char* path, uint32_t width, uint32_t height, const uint8_t* rgb);

#ifdef __cplusplus
}
#endif
#endif
