// SPDX-License-Identifier: MIT
#include "render/gl/stream.h"

#include <numeric>

namespace polhode {

VertexStream::VertexStream(const Gl& gl, std::initializer_list<int> attributes) : gl_(gl) {
  gl.GenVertexArrays(1, &array_);
  gl.GenBuffers(1, &vertices_);
  gl.GenBuffers(1, &indices_);
  gl.BindVertexArray(array_);
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices_);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
  const int stride =
      std::accumulate(attributes.begin(), attributes.end(), 0) * static_cast<int>(sizeof(float));
  GLuint index = 0;
  std::size_t offset = 0;
  for (int floats : attributes) {
    gl.VertexAttribPointer(index, floats, GL_FLOAT, GL_FALSE, stride, reinterpret_cast<const void*>(offset));
    gl.EnableVertexAttribArray(index++);
    offset += static_cast<std::size_t>(floats) * sizeof(float);
  }
}

VertexStream::~VertexStream() {
  gl_.DeleteVertexArrays(1, &array_);
  gl_.DeleteBuffers(1, &vertices_);
  gl_.DeleteBuffers(1, &indices_);
}

void VertexStream::draw_without_vertices(GLenum mode, int count) const {
  gl_.BindVertexArray(array_);
  gl_.DrawArrays(mode, 0, count);
}

void VertexStream::upload_floats(const void* vertices, std::size_t bytes,
                                 const std::vector<std::uint32_t>& indices) const {
  gl_.BindVertexArray(array_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_);
  gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), vertices, GL_STREAM_DRAW);
  gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)),
                 indices.data(), GL_STREAM_DRAW);
}

void VertexStream::draw_range(std::size_t first, std::size_t count) const {
  if (count == 0) return;
  gl_.BindVertexArray(array_);
  gl_.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(count), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(first * sizeof(std::uint32_t)));
}

}  // namespace polhode
