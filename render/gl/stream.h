// SPDX-License-Identifier: MIT
// Vertices that are new in every frame: one vertex array with its buffers. Internal to render/gl/.
#pragma once

#include "render/gl/context/functions.h"
#include "render/gl/passes/geometry.h"

#include <initializer_list>

namespace polhode {

/// Attributes 0, 1, … of the given numbers of floats, interleaved. `gl` must outlive it.
class VertexStream {
 public:
  VertexStream(const Gl& gl, std::initializer_list<int> attributes);
  ~VertexStream();
  VertexStream(const VertexStream&) = delete;
  VertexStream& operator=(const VertexStream&) = delete;

  template <class Vertex>
  void draw(const Geometry<Vertex>& geometry) const {
    upload(geometry);
    draw_range(0, geometry.indices.size());
  }
  /// For draw_range: triangles of `count` indices from the one numbered `first`.
  template <class Vertex>
  void upload(const Geometry<Vertex>& geometry) const {
    upload_floats(geometry.vertices.data(), geometry.vertices.size() * sizeof(Vertex), geometry.indices);
  }
  void draw_range(std::size_t first, std::size_t count) const;

  /// For shaders that make their vertices from gl_VertexID.
  void draw_without_vertices(GLenum mode, int count) const;

 private:
  void upload_floats(const void* vertices, std::size_t bytes,
                     const std::vector<std::uint32_t>& indices) const;

  const Gl& gl_;
  GLuint array_ = 0, vertices_ = 0, indices_ = 0;
};

}  // namespace polhode
