#include "widgets/relief/relief_renderer.h"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <thread>
#include <utility>

#include <QElapsedTimer>
#include <QMetaObject>
#include <QThread>

#include "core/base/hand_over.h"

namespace usar::widgets {

namespace {

/// Strips of the picture go to whichever thread is free, because some show more of the map than others.
void drawByStrips(const mapping::ReliefScene& scene, mapping::ReliefPicture& picture) {
    const int threads = std::clamp(QThread::idealThreadCount(), 1, 8);
    const int strips = threads == 1 ? 1 : 4 * threads;
    std::atomic<int> next = 0;
    const auto work = [&] {
        for (int strip = next++; strip < strips; strip = next++)
            mapping::drawRelief(scene, picture,
                                {picture.width_px * strip / strips, picture.width_px * (strip + 1) / strips});
    };
    std::vector<std::jthread> others;
    for (int i = 1; i < threads; ++i)
        others.emplace_back(work);
    work();
}

} // namespace

ReliefRenderer::ReliefRenderer(QObject* parent) : QObject(parent) {
    pool_.setMaxThreadCount(1);
}

ReliefRenderer::~ReliefRenderer() {
    pool_.waitForDone();
}

void ReliefRenderer::draw(ReliefRequest request) {
    if (working_)
        waiting_ = std::move(request);
    else
        start(std::move(request));
}

void ReliefRenderer::renew(Made& made, const ReliefRequest& request) {
    std::vector<mapping::GridIndex> changed;
    bool gone = false;
    for (const auto& [index, tile] : made.tiles)
        gone = gone || !request.tiles.contains(index);
    if (gone) // The map was cleared.
        made = {};
    for (const auto& [index, tile] : request.tiles)
        if (const auto before = made.tiles.find(index); before == made.tiles.end() || before->second != tile)
            changed.push_back(index);
    mapping::renewRelief(made.surface, request.tiles, request.cell_size_m, request.style, changed);
    made.tiles = request.tiles;
}

std::shared_ptr<const ReliefFrame> ReliefRenderer::work(Made& made, ReliefRequest request) {
    renew(made, request);
    mapping::ReliefScene& scene = request.scene;
    scene.surface = made.surface;
    for (mapping::ReliefLine& line : scene.lines)
        line.points_in_map_m = mapping::aboveSurface(scene.surface, line.points_in_map_m);
    if (request.show_all) {
        std::vector<Vec3> seen = scene.surface.someCorners();
        for (const mapping::ReliefLine& line : scene.lines) // Trails over the surface, but not those far away from it.
            std::ranges::copy_if(line.points_in_map_m, std::back_inserter(seen), [&scene](const Vec3& point) {
                return scene.surface.height_m(point.head<2>()).has_value();
            });
        scene.camera =
            scene.camera.showing(seen, double(request.size_px.width()) / request.size_px.height(), scene.exaggeration);
    }
    scene.camera = scene.camera.limited();
    for (const Rectangle& area : request.areas_in_map)
        scene.lines.push_back(
            {mapping::outlineOnSurface(scene.surface, area), request.area_color, request.edge_color, 2});
    auto frame = std::make_shared<ReliefFrame>();
    frame->picture = {request.size_px.width(), request.size_px.height()};
    frame->camera = scene.camera;
    frame->exaggeration = scene.exaggeration;
    QElapsedTimer clock;
    clock.start();
    drawByStrips(scene, frame->picture);
    frame->took_ms = double(clock.nsecsElapsed()) / 1e6;
    return frame;
}

void ReliefRenderer::start(ReliefRequest request) {
    working_ = true;
    pool_.start(HandedOver([this, request = std::move(request)]() mutable {
        auto frame = work(*made_, std::move(request));
        // The destructor waits for this job, so `this` is valid here; if the object is destroyed, the queued call is
        // discarded.
        QMetaObject::invokeMethod(this, HandedOver([this, frame = std::move(frame)] {
                                      working_ = false;
                                      ++frames_;
                                      if (waiting_)
                                          start(*std::exchange(waiting_, std::nullopt));
                                      emit drawn(frame);
                                  }),
                                  Qt::QueuedConnection);
    }));
}

} // namespace usar::widgets
