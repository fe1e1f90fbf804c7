#include "core/server/picture_maker.h"

#include <algorithm>

#include "core/sim/camera/renderer.h"

namespace usar::server {

const sim::Picture& PictureMaker::pictureFor(const PictureOrder& order) {
    const auto known = std::ranges::find_if(
        kept_, [&](const Kept& one) { return one.tick == order.scene->tick && one.camera == order.camera; });
    if (known != kept_.end())
        return known->picture;
    kept_.prepend(
        {order.scene->tick, order.camera, sim::windowPicture(*order.scene, order.camera ? &*order.camera : nullptr)});
    if (kept_.size() > most_kept)
        kept_.removeLast();
    ++made_;
    return kept_.first().picture;
}

void PictureMaker::make(const PictureOrder& order) {
    if (given_up_)
        return;
    const sim::Picture& whole = pictureFor(order);
    const auto& part = order.request.part;
    emit frameMade(order.viewer, part
                                     ? frameOf(sim::cut(whole, part->x, part->y, part->width, part->height), order.type)
                                     : frameOf(whole, order.type));
}

} // namespace usar::server
