// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mesh_io/assets/import.hpp"

#include "engine/text/printable.hpp"

#if SONDE_ASSIMP

#include <assimp/BaseImporter.h>
#include <assimp/config.h>
#include <assimp/scene.h>
#include <locale.h>

#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <memory>
#include <system_error>

#include "engine/base/progress.hpp"
#include "engine/mesh_io/assets/packed_soup.hpp"
#include "engine/platform/child_process.hpp"

namespace sonde {
namespace {

/// Opens nothing: whatever a model names lies elsewhere.
class NoFiles : public Assimp::IOSystem {
 public:
  bool Exists(const char*) const override { return false; }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char*, const char*) override { return nullptr; }
  void Close(Assimp::IOStream*) override {}
};

/// Numbers with a '.', whatever the locale, for the library.
class ClassicNumbers {
 public:
  ClassicNumbers() : classic_(newlocale(LC_NUMERIC_MASK, "C", nullptr)) {}
  ~ClassicNumbers() {
    if (classic_) freelocale(classic_);
  }
  ClassicNumbers(const ClassicNumbers&) = delete;
  ClassicNumbers& operator=(const ClassicNumbers&) = delete;
  /// In this thread, from now on.
  void use() const { uselocale(classic_); }

 private:
  locale_t classic_;
};

/// Leaves the importers of one extension: the library would try all others, too.
void keep_importers(Assimp::Importer& importer, std::string_view extension) {
  for (std::size_t k = importer.GetImporterCount(); k-- > 0;) {
    Assimp::BaseImporter* const one = importer.GetImporter(k);
    const std::string known = std::string(" ") + importer.GetImporterInfo(k)->mFileExtensions + " ";
    if (known.find(' ' + std::string(extension) + ' ') != known.npos) continue;
    importer.UnregisterLoader(one);
    delete one;  // ours, once it is no longer the importer's
  }
}

using Placement = Eigen::Matrix<double, 3, 4>;

Placement placement_of(const aiMatrix4x4& m) {
  Placement out;
  out << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4;
  return out;
}

class Collector {
 public:
  Collector(const std::string& file, const aiScene& scene, double scale)
      : file_(file), scene_(scene), scale_(scale) {}

  PolygonSoup collect(std::uint64_t corners) {
    add(*scene_.mRootNode, Placement::Identity());
    // The library leaves out what it takes for wrong, and goes on.
    if (corners != corners_)
      throw InputError::in(file_, "of " + std::to_string(corners) + " corners of faces " +
                                      std::to_string(corners_) + " can be read");
    if (out_.polygons.empty()) throw InputError::in(file_, "the file places no mesh with faces");
    if (thin_ > 0)
      out_.remarks.push_back(std::to_string(thin_) +
                             (thin_ == 1 ? " point or line" : " points and lines") +
                             " set aside: they bound nothing");
    return std::move(out_);
  }

 private:
  void add(const aiNode& node, const Placement& outer) {
    const Placement own = placement_of(node.mTransformation);
    Placement here;
    here.leftCols<3>() = outer.leftCols<3>() * own.leftCols<3>();
    here.col(3) = outer.leftCols<3>() * own.col(3) + outer.col(3);
    for (unsigned k = 0; k < node.mNumMeshes; ++k) {
      if (node.mMeshes[k] >= scene_.mNumMeshes) throw InputError::in(file_, "a mesh is missing");
      add(*scene_.mMeshes[node.mMeshes[k]], here);
    }
    for (unsigned k = 0; k < node.mNumChildren; ++k) add(*node.mChildren[k], here);
  }

  void add(const aiMesh& mesh, const Placement& here) {
    const std::size_t before = out_.points.size();
    const bool mirrors = here.leftCols<3>().determinant() < 0;
    for (unsigned k = 0; k < mesh.mNumVertices; ++k) {
      const aiVector3D& v = mesh.mVertices[k];
      const Vec3 x = scale_ * (here.leftCols<3>() * Vec3(v.x, v.y, v.z) + here.col(3));
      if (!x.allFinite()) throw InputError::in(file_, "a coordinate is not finite");
      out_.points.push_back(x);
    }
    for (unsigned k = 0; k < mesh.mNumFaces; ++k) {
      const aiFace& face = mesh.mFaces[k];
      corners_ += face.mNumIndices;
      if (face.mNumIndices < 3) {
        ++thin_;
        continue;
      }
      Polygon& polygon = out_.polygons.emplace_back();
      polygon.reserve(face.mNumIndices);
      for (unsigned i = 0; i < face.mNumIndices; ++i) {
        const unsigned at = face.mIndices[mirrors ? face.mNumIndices - 1 - i : i];
        if (at >= mesh.mNumVertices)
          throw InputError::in(file_, "a face names corner " + std::to_string(at) + " of " +
                                          std::to_string(mesh.mNumVertices));
        polygon.push_back(before + at);
      }
    }
  }

  const std::string& file_;
  const aiScene& scene_;
  double scale_;
  PolygonSoup out_;
  std::size_t thin_ = 0;
  std::uint64_t corners_ = 0;  // of faces and lines
};

/// What the library makes of it; a word of its own where it refuses.
PolygonSoup import_here(const std::string& file, std::string_view bytes, const char* extension,
                        double scale, std::uint64_t corners) {
  Assimp::Importer importer;
  keep_importers(importer, extension);
  importer.SetIOHandler(new NoFiles);  // the importer's from now on
  // Without meshes it would make one of the nodes.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, extension);
  if (!scene || !scene->mRootNode)
    throw InputError::in(file, "cannot be read: " + printable(importer.GetErrorString()));
  return Collector(file, *scene, scale).collect(corners);
}

}  // namespace

PolygonSoup import_model(const std::string& file, std::string_view bytes, const char* extension,
                         double scale, std::uint64_t corners, const Progress& progress) {
  const ClassicNumbers numbers;
  ChildEnd end;
  try {
    end = in_child_process(
        [&] {
          numbers.use();
          try {
            return packed(import_here(file, bytes, extension, scale, corners));
          } catch (const InputError& error) {
            return packed(error);
          }
        },
        progress);
  } catch (const std::system_error& none) {
    throw InputError::in(file, std::string("no process can be had to read it in: ") + none.what());
  }
  if (end.signal != 0 || end.threw)
    throw InputError::in(
        file, "cannot be read: assimp " +
                  (end.signal == 0 ? std::string("does not get to the end of it")
                                   : "ends by signal " + std::to_string(end.signal) + " in it"));
  PolygonSoup out = unpacked(file, end.output);
  report(progress, 1);
  return out;
}

}  // namespace sonde

#else

namespace sonde {

PolygonSoup import_model(const std::string& file, std::string_view, const char*, double,
                         std::uint64_t, const Progress&) {
  throw InputError::in(file, "this Sonde was built without assimp, which reads files of this kind");
}

}  // namespace sonde

#endif
