/* SPDX-License-Identifier: Apache-2.0 */
/* Asks an installed library of the C interface for its version, and for a file that it cannot read. */
#include <crossgrain/c.h>
#include <stdio.h>

#if CROSSGRAIN_VERSION_NUMBER < 100
#error "0.1.0 is 100"
#endif

int main(int argc, char** argv) {
  crossgrain_mesh* mesh = NULL;
  crossgrain_error* error = NULL;
  printf("crossgrain %s\n", crossgrain_version());
  if (argc > 1 && crossgrain_mesh_read(argv[1], NULL, NULL, &mesh, &error) != CROSSGRAIN_OK) {
    printf("%s\n", error->sentence);
    crossgrain_error_free(error);
  }
  crossgrain_mesh_free(mesh);
  return crossgrain_c_version() == CROSSGRAIN_C_VERSION ? 0 : 1;
}
