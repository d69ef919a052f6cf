#include "picture/tube_scene.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

namespace knitmech::picture {
namespace {

using Eigen::Vector3d;

RTCRay ray_from(const Vector3d& origin, const Vector3d& direction, double distance) {
  RTCRay ray{};
  ray.org_x = static_cast<float>(origin.x());
  ray.org_y = static_cast<float>(origin.y());
  ray.org_z = static_cast<float>(origin.z());
  ray.dir_x = static_cast<float>(direction.x());
  ray.dir_y = static_cast<float>(direction.y());
  ray.dir_z = static_cast<float>(direction.z());
  ray.tnear = 0;
  ray.tfar = static_cast<float>(distance);
  ray.mask = ~0U;
  return ray;
}

/// Vertices, segments and neighbour flags in the form of Embree.
struct Segments {
  std::vector<Eigen::Vector4f> vertices;  ///< x, y, z, radius
  std::vector<unsigned> first_vertex;     ///< of each segment
  std::vector<unsigned char> flags;
};

Segments cut(const std::vector<model::CurvePiece>& pieces) {
  Segments segments;
  const auto add_vertex = [&segments](const model::CurvePiece& piece, double u) {
    const Eigen::Vector3f point = piece.point(u).cast<float>();
    segments.vertices.emplace_back(point.x(), point.y(), point.z(), static_cast<float>(piece.radius));
  };
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const model::CurvePiece& piece = pieces[p];
    const bool continued = p + 1 < pieces.size() && pieces[p + 1].continues_piece_before;
    if (!piece.continues_piece_before) {
      add_vertex(piece, 0);
    }
    for (int k = 0; k < kStraightPiecesPerElement; ++k) {
      unsigned flags = 0;
      if (k > 0 || piece.continues_piece_before) {
        flags |= RTC_CURVE_FLAG_NEIGHBOR_LEFT;
      }
      if (k + 1 < kStraightPiecesPerElement || continued) {
        flags |= RTC_CURVE_FLAG_NEIGHBOR_RIGHT;
      }
      segments.first_vertex.push_back(static_cast<unsigned>(segments.vertices.size() - 1));
      segments.flags.push_back(static_cast<unsigned char>(flags));
      add_vertex(piece, static_cast<double>(k + 1) / kStraightPiecesPerElement);
    }
  }
  return segments;
}

template <typename Value>
void set_buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, const std::vector<Value>& values) {
  void* buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(Value), values.size());
  if (buffer == nullptr) {
    throw std::bad_alloc();
  }
  std::copy(values.begin(), values.end(), static_cast<Value*>(buffer));
}

}  // namespace

struct TubeScene::Handles {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  Handles() = default;
  Handles(const Handles&) = delete;
  Handles& operator=(const Handles&) = delete;
  Handles(Handles&&) = delete;
  Handles& operator=(Handles&&) = delete;
  ~Handles() {
    if (scene != nullptr) {
      rtcReleaseScene(scene);
    }
    if (device != nullptr) {
      rtcReleaseDevice(device);
    }
  }
};

TubeScene::TubeScene(std::vector<model::CurvePiece> pieces)
    : pieces_(std::move(pieces)), handles_(std::make_unique<Handles>()) {
  // One building thread, so that the tree, and with it every rounding, is the same in each run.
  handles_->device = rtcNewDevice("threads=1");
  if (handles_->device == nullptr) {
    throw std::runtime_error("Embree, which draws the yarns, cannot be started on this processor.");
  }
  handles_->scene = rtcNewScene(handles_->device);
  const Segments segments = cut(pieces_);
  if (!segments.first_vertex.empty()) {
    RTCGeometry geometry = rtcNewGeometry(handles_->device, RTC_GEOMETRY_TYPE_ROUND_LINEAR_CURVE);
    set_buffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, segments.vertices);
    set_buffer(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT, segments.first_vertex);
    set_buffer(geometry, RTC_BUFFER_TYPE_FLAGS, RTC_FORMAT_UCHAR, segments.flags);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(handles_->scene, geometry);
    rtcReleaseGeometry(geometry);
  }
  rtcCommitScene(handles_->scene);
}

TubeScene::~TubeScene() = default;

std::optional<TubeHit> TubeScene::first_hit(const Vector3d& origin, const Vector3d& direction) const {
  RTCRayHit query{};
  query.ray = ray_from(origin, direction, std::numeric_limits<double>::infinity());
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context{};
  rtcInitIntersectContext(&context);
  rtcIntersect1(handles_->scene, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
    return std::nullopt;
  }
  const int segment = static_cast<int>(query.hit.primID);
  TubeHit hit;
  hit.piece = segment / kStraightPiecesPerElement;
  hit.parameter = (segment % kStraightPiecesPerElement + static_cast<double>(query.hit.u)) / kStraightPiecesPerElement;
  hit.point = origin + static_cast<double>(query.ray.tfar) * direction;
  // The tube is drawn in straight pieces but shaded as the smooth one.
  const model::CurvePiece& piece = pieces_[static_cast<std::size_t>(hit.piece)];
  const Vector3d tangent = piece.tangent(hit.parameter);
  const Vector3d outward = hit.point - piece.point(hit.parameter);
  const Vector3d across = outward - outward.dot(tangent) * tangent;
  hit.normal = across.norm() > 0 ? Vector3d(across.normalized()) : Vector3d(-direction);
  return hit;
}

bool TubeScene::is_blocked(const Vector3d& origin, const Vector3d& direction, double distance) const {
  RTCRay ray = ray_from(origin, direction, distance);
  RTCIntersectContext context{};
  rtcInitIntersectContext(&context);
  rtcOccluded1(handles_->scene, &context, &ray);
  return ray.tfar < 0;
}

}  // namespace knitmech::picture
