// Sight of a skin: what its surface hides cannot be taken hold of, unless it is seen through.

#include "ui/view/skin_sight.hpp"

#include <numbers>

#include "core/skinning/columns/simple_skin.hpp"
#include "tests/app/skin_rig.hpp"
#include "tests/support/random.hpp"
#include "ui/skin/skin_tools.hpp"

namespace hariko::test {
namespace {

/// A straight tube along x with round sections of eight points.
Skin tube() {
  Skin skin;
  for (int i = 0; i < 4; ++i) skin.path.points.push_back(Vector3(2 * i, 0, 0));
  std::uint32_t id = 0;
  for (int k = 0; k < 3; ++k) {
    SkinSection section;
    section.id = std::uint32_t(k);
    section.v = k / 2.0;
    section.closed = true;
    for (int i = 0; i < 8; ++i) {
      const double a = std::numbers::pi * i / 4;
      section.points.push_back({id++, Vector3(3.0 * k, std::cos(a), std::sin(a)), false});
    }
    skin.sections.push_back(section);
  }
  return skin;
}

struct SightRig : SkinRig {
  explicit SightRig(const Skin& skin) : SkinRig(skin, StandardView::front) {
    editor.mode = ElementMode::vertex;
    update();
  }
  Projector projector() const { return {editor.camera(), editor.viewport}; }
  SkinSight sight() const { return {editor, projector(), view, object()}; }
  /// Index of the handle of a section point on the curve.
  std::size_t limit(std::uint32_t id) const {
    for (std::size_t i = 0; i < view.handles.size(); ++i)
      if (view.handles[i].kind == SkinView::Handle::Kind::limit && view.handles[i].id == id) return i;
    ADD_FAILURE() << "no point " << id;
    return 0;
  }
  Vector2 pixel_of_limit(std::uint32_t id) const { return pixel(view.handles[limit(id)].position); }
  bool taken(std::uint32_t id) {
    PointerEvent press;
    press.kind = PointerEvent::Kind::press;
    press.pixel = pixel_of_limit(id);
    return skin_tool_at(context(), press) != nullptr;
  }
};

TEST(SkinSight, PointsInFrontWinAndHiddenOnesAreLeftAlone) {
  SightRig rig(tube());
  // From the front, along +y, points 8 + 4 (nearest), + 3 and + 5 are before the tube, + 0, + 1 and + 7
  // behind it, at the same places of the picture or nearly so.
  for (const std::uint32_t front : {11U, 12U, 13U}) {
    EXPECT_FALSE(rig.sight().hides_handle(rig.limit(front))) << front;
    const SkinHit hit = rig.sight().hit(rig.projector(), rig.pixel_of_limit(front), 1);
    ASSERT_EQ(hit.kind, SkinHit::Kind::handle);
    EXPECT_EQ(rig.view.handles[hit.index].id, front);
  }
  for (const std::uint32_t back : {8U, 9U, 15U})
    EXPECT_TRUE(rig.sight().hides_handle(rig.limit(back))) << back;
  // Up to the silhouette nothing is hidden.
  for (const std::uint32_t edge : {10U, 14U}) EXPECT_FALSE(rig.sight().hides_handle(rig.limit(edge))) << edge;
  // The path runs inside of the tube and can be taken hold of.
  const SkinHit path = rig.sight().hit(rig.projector(), rig.pixel({2, 0, 0}), 1);
  ASSERT_EQ(path.kind, SkinHit::Kind::handle);
  EXPECT_TRUE(is_path_point(rig.view.handles[path.index].id));
}

TEST(SkinSight, SeenThroughHiddenPointsAreTakenHoldOf) {
  SightRig rig(tube());
  // A little from the side, so that no point in front covers one behind.
  rig.editor.set_camera(Camera::standard(StandardView::front).orbit(0.35, 0.3));
  rig.editor.frame_all(true);
  const std::uint32_t back = 9;
  ASSERT_TRUE(rig.sight().hides_handle(rig.limit(back)));
  const auto hits_it = [&] {
    const SkinHit hit = rig.sight().hit(rig.projector(), rig.pixel_of_limit(back), 1);
    return hit.kind == SkinHit::Kind::handle && rig.view.handles[hit.index].id == back;
  };
  EXPECT_FALSE(hits_it());
  EXPECT_FALSE(rig.taken(back));
  EXPECT_TRUE(rig.sight().hidden_points().contains(back));
  rig.editor.view.x_ray = true;
  EXPECT_TRUE(hits_it());
  EXPECT_TRUE(rig.taken(back));
  EXPECT_TRUE(rig.sight().hidden_points().empty());
  rig.editor.view.x_ray = false;
  rig.editor.selecting.through = true;
  EXPECT_TRUE(hits_it());
  rig.editor.selecting.through = false;
  // While the sections make no surface, the last one does not keep them from being mended.
  rig.views[rig.object().id].error = make_error(Code{"E_TEST"}, "no surface");
  EXPECT_TRUE(hits_it());
}

TEST(SkinSight, PointsThatTheSurfaceMissesAreSeenWhereItIs) {
  Skin skin = tube();
  // A waist that the surface does not reach: its points lie below the surface.
  for (SectionPoint& p : skin.sections[1].points) p.position.y() *= 0.5, p.position.z() *= 0.5;
  skin.pleat.fit = SectionFit::none;
  const SightRig rig(skin);
  EXPECT_FALSE(rig.sight().hides_handle(rig.limit(12)));
  EXPECT_TRUE(rig.sight().hides_handle(rig.limit(8)));
}

/// Against rays, at random places of a surface from random directions.
TEST(SurfaceOcclusion, HidesWhatRaysDoNotReachButNothingInSight) {
  int all_hidden = 0, all_found = 0;
  for_random(951, 12, [&](std::mt19937_64& rng) {
    SightRig rig(tube());
    rig.editor.set_camera(
        Camera::standard(StandardView::front).orbit(uniform(rng, -3, 3), uniform(rng, -1.2, 1.2)));
    rig.editor.frame_all(true);
    const Scene& scene = rig.scene.scene();
    const SurfaceOcclusion occlusion(scene.objects, {}, rig.projector());
    const Surface& surface = rig.views.begin()->second.surface;
    int hidden = 0, found = 0;
    for (int i = 0; i < 300; ++i) {
      const Index patch = Index(uniform_int(rng, 0, int(surface.patch_count()) - 1));
      const Vector3 p =
          surface.patches().evaluate(patch, {uniform(rng, 0, 1), uniform(rng, 0, 1)}, Order::first).position;
      const Ray ray = rig.projector().ray(rig.pixel(p));
      const auto hit = pick_surface(scene, ray);
      const double own = (p - ray.origin).dot(ray.direction);
      if (!hit || hit->t > own - 0.02) {
        EXPECT_FALSE(occlusion.hides(p)) << p.transpose();
      } else if (hit->t < own - 0.3) {
        ++hidden;
        found += occlusion.hides(p);
      }
    }
    // Along its axis all of a tube is in sight. Elsewhere hidden places are found but for a rim along
    // silhouettes, which takes a larger part where the tube is foreshortened.
    if (hidden < 50) return;
    EXPECT_GT(found, 0.4 * hidden);
    all_hidden += hidden;
    all_found += found;
  });
  EXPECT_GT(all_found, 0.7 * all_hidden);
}

}  // namespace
}  // namespace hariko::test
