// SPDX-License-Identifier: MIT
// peer_mujoco SCENE.json FOLDER [full]: the scene with MuJoCo, off-screen through EGL, 4 samples, PNG by
// polhode's own fast writer. `full` adds what MuJoCo has of our shadow and mirror image. One line of JSON
// tells what a frame cost.
//
// Curves are meshes made once, one for each, because a capsule for each of 3,500 segments would be a draw
// call each. The body is a mocap body: frames need no dynamics.
#include "render/image/png.h"
#include "tests/bench/timing.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <Eigen/Geometry>
#include <fmt/format.h>
#include <mujoco/mujoco.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <stdexcept>

namespace polhode::bench {
namespace {

using Json = nlohmann::json;
using Vec3 = Eigen::Vector3d;

constexpr int kWidth = 1920, kHeight = 1080;
constexpr int kTubeSides = 8;
constexpr double kGlassOpacity = 0.35, kFloorOpacity = 0.75;
constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr int kWarmUp = 3;

Vec3 vec3(const Json& v) { return Vec3(v[0].get<double>(), v[1].get<double>(), v[2].get<double>()); }
std::string words(const Vec3& v) { return fmt::format("{:.7g} {:.7g} {:.7g}", v.x(), v.y(), v.z()); }
std::string rgba(const Json& color, double opacity = 1.0) {
  return fmt::format("{} {} {} {}", color[0].get<double>(), color[1].get<double>(), color[2].get<double>(),
                     opacity);
}

// ---- the model, as MuJoCo's XML -----------------------------------------------------------------------

/// A tube of kTubeSides round the curve, its ends closed; the ring is carried along without twist.
std::string tube_mesh(const Json& curve, const std::string& name) {
  std::vector<Vec3> line;
  for (const Json& point : curve["points"]) line.push_back(vec3(point));
  if (curve["closed"].get<bool>()) line.push_back(line.front());
  const double radius = curve["radius"].get<double>();
  std::string vertices, faces;
  Vec3 normal = (line[1] - line[0]).unitOrthogonal();
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Vec3 along = (line[std::min(i + 1, line.size() - 1)] - line[i > 0 ? i - 1 : 0]).normalized();
    normal = (normal - normal.dot(along) * along).normalized();
    const Vec3 across = along.cross(normal);
    for (int k = 0; k < kTubeSides; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / kTubeSides;
      vertices += words(line[i] + radius * (std::cos(angle) * normal + std::sin(angle) * across)) + " ";
    }
  }
  const auto at = [](std::size_t ring, int k) {
    return static_cast<int>(ring) * kTubeSides + k % kTubeSides;
  };
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    for (int k = 0; k < kTubeSides; ++k)
      faces += fmt::format("{} {} {} {} {} {} ", at(i, k), at(i, k + 1), at(i + 1, k + 1), at(i, k),
                           at(i + 1, k + 1), at(i + 1, k));
  for (int k = 1; k + 1 < kTubeSides; ++k)
    faces += fmt::format("{} {} {} {} {} {} ", at(0, 0), at(0, k + 1), at(0, k), at(line.size() - 1, 0),
                         at(line.size() - 1, k), at(line.size() - 1, k + 1));
  return fmt::format("<mesh name='{}' vertex='{}' face='{}'/>\n", name, vertices, faces);
}

struct Curves {
  std::string meshes, geoms;
};
Curves curves_of(const Json& curves, const std::string& prefix) {
  Curves made;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const std::string name = prefix + std::to_string(i);
    made.meshes += tube_mesh(curves[i], name);
    made.geoms += fmt::format("<geom type='mesh' mesh='{}' rgba='{}'/>\n", name, rgba(curves[i]["color"]));
  }
  return made;
}

/// One cell of the floor's grid as a picture: a heavy line at its edges, four light ones between them.
std::vector<std::uint8_t> grid_png() {
  constexpr int kSide = 640;
  Image cell = Image::blank({kSide, kSide});
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const auto near = [](int at, int spacing, int half) { return (at + half) % spacing < 2 * half; };
      const bool heavy = near(x, kSide, 5) || near(y, kSide, 5);
      const bool light = near(x, kSide / 5, 3) || near(y, kSide / 5, 3);
      const std::array<std::uint8_t, 4> color = heavy   ? std::array<std::uint8_t, 4>{168, 181, 194, 255}
                                                : light ? std::array<std::uint8_t, 4>{201, 211, 222, 255}
                                                        : std::array<std::uint8_t, 4>{224, 230, 237, 255};
      std::memcpy(&cell.rgba[4U * static_cast<std::size_t>(y * kSide + x)], color.data(), 4);
    }
  return encode_png(cell, {}).value();
}

std::string model_xml(const Json& scene, bool full) {
  const Curves body = curves_of(scene["body_curves"], "body"),
               space = curves_of(scene["space_curves"], "space");
  const Json& ball = scene["ball"];
  return fmt::format(
      R"(<mujoco>
<visual>
  <global offwidth='{width}' offheight='{height}' fovy='{fovy}'/>
  <quality offsamples='4' numslices='96' numstacks='48' shadowsize='2048'/>
  <headlight ambient='0.4 0.4 0.4' diffuse='0.2 0.2 0.2' specular='0.1 0.1 0.1'/>
  <map znear='0.3' zfar='20'/>
</visual>
<statistic extent='1' center='0 0 0'/>
<asset>
  <texture name='sky' type='skybox' builtin='gradient' rgb1='0.93 0.94 0.95' rgb2='0.82 0.85 0.88' width='64' height='384'/>
  <texture name='grid' type='2d' file='grid.png'/>
  <material name='grid' texture='grid' texrepeat='2 2' texuniform='true' specular='0' reflectance='{reflectance}' rgba='1 1 1 {floor_opacity}'/>
  <material name='glass' rgba='{glass}' specular='0.9' shininess='0.8'/>
  {meshes}
</asset>
<default><geom contype='0' conaffinity='0' mass='1'/></default>
<worldbody>
  <light directional='true' pos='2 1 4' dir='-2 -1 -4' diffuse='0.6 0.6 0.6' castshadow='{shadow}'/>
  <geom type='plane' size='4 4 1' pos='0 0 {floor}' material='grid'/>
  <geom type='sphere' size='{ball}' rgba='{ball_color}'/>
  {space_geoms}
  <body name='body' mocap='true'>
    <geom type='ellipsoid' size='{axes}' material='glass'/>
    {body_geoms}
  </body>
</worldbody>
</mujoco>)",
      fmt::arg("width", kWidth), fmt::arg("height", kHeight),
      fmt::arg("fovy", scene["frames"][0]["fov_y_rad"].get<double>() * kDegrees),
      fmt::arg("reflectance", full ? 0.15 : 0.0), fmt::arg("floor_opacity", full ? 1.0 : kFloorOpacity),
      fmt::arg("glass", rgba(scene["ellipsoid"]["color"], kGlassOpacity)), fmt::arg("shadow", full),
      fmt::arg("meshes", body.meshes + space.meshes), fmt::arg("floor", scene["floor"]["z"].get<double>()),
      fmt::arg("ball", ball["radius"].get<double>()), fmt::arg("ball_color", rgba(ball["color"])),
      fmt::arg("space_geoms", space.geoms), fmt::arg("body_geoms", body.geoms),
      fmt::arg("axes", words(vec3(scene["ellipsoid"]["semi_axes"]))));
}

void put(mjVFS& files, const char* name, const void* bytes, std::size_t size) {
  if (mj_makeEmptyFileVFS(&files, name, static_cast<int>(size)) != 0)
    throw std::runtime_error("MuJoCo takes no more files");
  std::memcpy(files.filedata[mj_findFileVFS(&files, name)], bytes, size);
}

mjModel* load_model(const Json& scene, bool full) {
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  const std::string xml = model_xml(scene, full);
  const std::vector<std::uint8_t> grid = grid_png();
  put(*files, "scene.xml", xml.data(), xml.size());
  put(*files, "grid.png", grid.data(), grid.size());
  std::array<char, 1000> told{};
  mjModel* model = mj_loadXML("scene.xml", files.get(), told.data(), told.size());
  mj_deleteVFS(files.get());
  if (!model) throw std::runtime_error(told.data());
  return model;
}

// ---- drawing ------------------------------------------------------------------------------------------

/// A current context of EGL without any surface; MuJoCo needs the compatibility profile.
void open_egl() {
  const auto platform_display =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  const EGLDisplay display =
      platform_display ? platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)
                       : EGL_NO_DISPLAY;
  const std::array<EGLint, 3> wanted{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config{};
  EGLint found = 0;
  if (!eglInitialize(display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API) ||
      !eglChooseConfig(display, wanted.data(), &config, 1, &found))
    throw std::runtime_error("EGL has no display without a surface");
  const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
  if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
    throw std::runtime_error("EGL gave no context");
}

class Film {
 public:
  Film(const Json& scene, bool full) : model_(load_model(scene, full)), data_(mj_makeData(model_)) {
    mjv_defaultOption(&option_);
    mjv_defaultScene(&scene_);
    mjr_defaultContext(&context_);
    mjv_makeScene(model_, &scene_, 200);
    mjr_makeContext(model_, &context_, mjFONTSCALE_150);
    mjr_setBuffer(mjFB_OFFSCREEN, &context_);
    if (context_.currentBuffer != mjFB_OFFSCREEN) throw std::runtime_error("no off-screen buffer");
    scene_.flags[mjRND_SHADOW] = scene_.flags[mjRND_REFLECTION] = full ? 1 : 0;
    rgb_.resize(3UL * kWidth * kHeight);
    image_ = Image::blank({kWidth, kHeight});
  }
  int samples() const { return context_.offSamples; }

  const Image& draw(const Json& frame) {
    for (int i = 0; i < 4; ++i)
      data_->mocap_quat[i] = frame["rotation"][static_cast<std::size_t>(i)].get<double>();
    mj_kinematics(model_, data_);
    mj_comPos(model_, data_);
    mj_camlight(model_, data_);
    mjvCamera camera = camera_of(frame);
    mjv_updateScene(model_, data_, &option_, nullptr, &camera, mjCAT_ALL, &scene_);
    for (const Json& arrow : frame["arrows"]) add_arrow(arrow);
    for (const Json& label : frame["labels"]) add_label(label);
    const mjrRect all{0, 0, kWidth, kHeight};
    mjr_render(all, &scene_, &context_);
    mjr_overlay(mjFONT_NORMAL, mjGRID_TOPLEFT, all, "I\n2T\n|L|\nL2/2T",
                "1.000 1.750 2.500\n8.558\n4.444\n2.307", &context_);
    mjr_readPixels(rgb_.data(), nullptr, all, &context_);
    flip();
    return image_;
  }

 private:
  static mjvCamera camera_of(const Json& frame) {
    mjvCamera camera;
    mjv_defaultCamera(&camera);
    const Vec3 target = vec3(frame["target"]), way = target - vec3(frame["eye"]);
    camera.type = mjCAMERA_FREE;
    for (int i = 0; i < 3; ++i) camera.lookat[i] = target[i];
    camera.distance = way.norm();
    camera.azimuth = std::atan2(way.y(), way.x()) * kDegrees;
    camera.elevation = std::asin(way.z() / way.norm()) * kDegrees;
    return camera;
  }

  mjvGeom& new_geom(int type, const Json& color) {
    if (scene_.ngeom >= scene_.maxgeom) throw std::runtime_error("too many geoms");
    mjvGeom& geom = scene_.geoms[scene_.ngeom++];
    const std::array<float, 4> paint{color[0].get<float>(), color[1].get<float>(), color[2].get<float>(),
                                     1.0F};
    mjv_initGeom(&geom, type, nullptr, nullptr, nullptr, paint.data());
    return geom;
  }
  void add_arrow(const Json& arrow) {
    const Vec3 tail = vec3(arrow["tail"]), tip = vec3(arrow["tip"]);
    mjvGeom& geom = new_geom(mjGEOM_ARROW, arrow["color"]);
    mjv_makeConnector(&geom, mjGEOM_ARROW, arrow["radius"].get<double>(), tail.x(), tail.y(), tail.z(),
                      tip.x(), tip.y(), tip.z());
    geom.size[2] *= 2.0F;  // half the distance, where drawing takes the whole
  }
  /// The font is ASCII.
  void add_label(const Json& label) {
    mjvGeom& geom = new_geom(mjGEOM_LABEL, label["color"]);
    const auto text = label["text"].get<std::string>();
    const char* ascii = text.find("omega") != std::string::npos ? "omega"
                        : text.find('$') != std::string::npos   ? "L"
                                                                : text.c_str();
    std::snprintf(geom.label, sizeof geom.label, "%s", ascii);
    for (int i = 0; i < 3; ++i) geom.pos[i] = label["anchor"][static_cast<std::size_t>(i)].get<float>();
  }
  /// OpenGL's rows come from the bottom.
  void flip() {
    for (std::size_t y = 0; y < kHeight; ++y) {
      const std::uint8_t* from = &rgb_[3UL * kWidth * (kHeight - 1 - y)];
      std::uint8_t* to = &image_.rgba[4UL * kWidth * y];
      for (std::size_t x = 0; x < kWidth; ++x, from += 3, to += 4) {
        to[0] = from[0], to[1] = from[1], to[2] = from[2], to[3] = 255;
      }
    }
  }

  mjModel* model_;  // of the process, as the context is
  mjData* data_;
  mjvOption option_{};
  mjvScene scene_{};
  mjrContext context_{};
  std::vector<unsigned char> rgb_;
  Image image_;
};

void write(PngEncoder& encoder, const std::filesystem::path& path, const Image& image) {
  const std::span<const std::uint8_t> png = encoder.encode(image, {}).value();
  std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(png.data()), std::ssize(png));
}

void run(const std::filesystem::path& scene_file, const std::filesystem::path& folder, bool full) {
  const Json scene = Json::parse(std::ifstream(scene_file));
  std::filesystem::create_directories(folder);
  open_egl();
  Film film(scene, full);
  PngEncoder encoder;
  const Json& frames = scene["frames"];
  for (int n = 0; n < kWarmUp; ++n) film.draw(frames[0]);

  const double cpu = read_s(CLOCK_PROCESS_CPUTIME_ID), wall = read_s(CLOCK_MONOTONIC);
  double drawing_s = 0.0;
  for (std::size_t n = 0; n < frames.size(); ++n) {
    const Image* image = nullptr;
    drawing_s += cpu_s([&] { image = &film.draw(frames[n]); });
    write(encoder, folder / fmt::format("{:05}.png", n), *image);
  }
  const double ms = 1000.0 / static_cast<double>(frames.size());
  fmt::print(
      R"({{"name": "MuJoCo{}", "version": "{} MSAA {}", "frames": {}, "cpu_ms": {:.2f}, "wall_ms": {:.2f}, "draw_cpu_ms": {:.2f}}})"
      "\n",
      full ? ", full" : "", mj_versionString(), film.samples(), frames.size(),
      (read_s(CLOCK_PROCESS_CPUTIME_ID) - cpu) * ms, (read_s(CLOCK_MONOTONIC) - wall) * ms, drawing_s * ms);
}

}  // namespace
}  // namespace polhode::bench

int main(int argc, char** argv) {
  const bool full = argc == 4 && std::string(argv[3]) == "full";
  if (argc != 3 && !full) {
    std::fputs("usage: peer_mujoco SCENE.json FOLDER [full]\n", stderr);
    return 2;
  }
  try {
    polhode::bench::run(argv[1], argv[2], full);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "peer_mujoco: %s\n", error.what());
    return 1;
  }
}
