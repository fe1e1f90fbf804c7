#include "core/mission/files/small_picture.h"

#include <algorithm>

#include <QBuffer>
#include <QImage>

#include "core/mapping/raster_export.h"

namespace usar::mission {

bool isMapPicture(const QString& file) {
    return file.endsWith(mapping::picture_ending);
}

QByteArray smallPicture(const QString& file, int most_px) {
    QImage picture(file);
    if (std::max(picture.width(), picture.height()) > most_px)
        picture = picture.scaled(most_px, most_px, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    QBuffer png;
    return !picture.isNull() && picture.save(&png, "PNG") ? png.data() : QByteArray();
}

} // namespace usar::mission
