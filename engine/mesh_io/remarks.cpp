// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mesh_io/remarks.hpp"

namespace sonde {

void remark(Remarks& remarks, const char* place, const Tally& tally, const char* one,
            const char* many) {
  if (tally.count == 0) return;
  remarks.push_back(std::string(place) + " " + std::to_string(tally.first) + ": " +
                    std::to_string(tally.count) + " " + (tally.count == 1 ? one : many));
}

void remark(Remarks& remarks, const char* place, const ThinFaces& faces) {
  if (faces.all_of_two)
    remark(remarks, place, faces.tally, "face of two corners set aside",
           "faces of two corners set aside");
  else
    remark(remarks, place, faces.tally, "face of fewer than three corners set aside",
           "faces of fewer than three corners set aside");
}

void remark_on_bytes(Remarks& remarks, std::uint64_t bytes, const char* after_what) {
  if (bytes == 0) return;
  remarks.push_back(std::to_string(bytes) + (bytes == 1 ? " byte" : " bytes") + " after " +
                    after_what + (bytes == 1 ? " is" : " are") + " not read");
}

}  // namespace sonde
