#include "widgets/models/height_difference.h"

#include <algorithm>
#include <cmath>

#include <QColor>
#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>

#include "widgets/models/figures.h"

namespace usar::widgets {

namespace {

const QColor equal_color(128, 128, 128);
const QColor higher_color(230, 126, 34);
const QColor lower_color(52, 120, 220);

QRgb mixed(const QColor& from, const QColor& to, double part) {
    const auto mix = [part](int a, int b) { return static_cast<int>(std::lround(a + part * (b - a))); };
    return qRgb(mix(from.red(), to.red()), mix(from.green(), to.green()), mix(from.blue(), to.blue()));
}

} // namespace

mapping::Raster readHeights(const QString& summary_path) {
    QFile summary(summary_path);
    const QFileInfo info(summary_path);
    QFile file(info.dir().filePath(info.completeBaseName() + ".bil"));
    if (!summary.open(QIODevice::ReadOnly) || !file.open(QIODevice::ReadOnly))
        return {};
    const QJsonObject map = QJsonDocument::fromJson(summary.readAll()).object()["map"].toObject();
    mapping::Raster raster{
        .columns = map["columns"].toInteger(),
        .rows = map["rows"].toInteger(),
        .cell_size_m = map["cell_size_m"].toDouble(),
        .upper_left_center_m = {map["upper_left_center_x_m"].toDouble(), map["upper_left_center_y_m"].toDouble()},
        .heights_m = {}};
    const QByteArray bytes = file.readAll();
    return mapping::takeBilBytes(raster, {bytes.constData(), static_cast<std::size_t>(bytes.size())})
               ? raster
               : mapping::Raster();
}

double fullColorOf_m(const mapping::RasterDifference& difference) {
    return std::max(0.05, 3.0 * difference.rms_m);
}

QImage differencePicture(const mapping::RasterDifference& difference, double full_m) {
    const mapping::Raster& raster = difference.second_minus_first;
    QImage picture(static_cast<int>(raster.columns), static_cast<int>(raster.rows), QImage::Format_ARGB32);
    picture.fill(Qt::transparent);
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
            const float change_m =
                raster
                    .heights_m[static_cast<std::size_t>(y) * std::size_t(raster.columns) + static_cast<std::size_t>(x)];
            if (std::isnan(change_m))
                continue;
            const double part = std::min(1.0, std::abs(double(change_m)) / full_m);
            picture.setPixel(x, y, mixed(equal_color, change_m > 0.0f ? higher_color : lower_color, part));
        }
    return picture;
}

QString differenceText(const mapping::RasterDifference& difference) {
    const auto tr = [](const char* text) { return QCoreApplication::translate("HeightDifference", text); };
    if (difference.in_both == 0)
        return tr("The maps have no cell in common.");
    return tr("Second map minus first: usual difference %1 m, largest %2 m; cells only in the first %3, only in the "
              "second %4. Orange is higher, blue lower; full color from %5 m on.")
        .arg(figure(difference.rms_m, 2), figure(difference.largest_m, 2))
        .arg(difference.only_first)
        .arg(difference.only_second)
        .arg(figure(fullColorOf_m(difference), 2));
}

} // namespace usar::widgets
