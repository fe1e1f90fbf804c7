#include "widgets/plan/plan_picture.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <QBuffer>
#include <QFileInfo>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QSaveFile>

#include "widgets/style/svg_paint.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

constexpr double most_pixels = 64e6;
constexpr double longest_side_px = 30'000.0;
constexpr double longest_page_pt = 14'400.0; ///< PDF viewers refuse larger pages
constexpr int pdf_dots_per_inch = 600;

QByteArray svg(PlanView& view) {
    SvgPaint device(view.drawingSize(), view.tree()[PlanNodeId{0}].name);
    QPainter painter(&device);
    view.paintDrawing(painter);
    painter.end();
    return device.document();
}

QByteArray pdf(PlanView& view) {
    const QSizeF size_pt = view.drawingSize() * 0.75; // 96 pixels are 72 points.
    const double shrunk = std::min(1.0, longest_page_pt / std::max(size_pt.width(), size_pt.height()));
    QBuffer bytes;
    bytes.open(QIODevice::WriteOnly);
    QPdfWriter writer(&bytes);
    writer.setTitle(view.tree()[PlanNodeId{0}].name);
    writer.setResolution(pdf_dots_per_inch);
    writer.setPageSize(QPageSize(size_pt * shrunk, QPageSize::Point, QString(), QPageSize::ExactMatch));
    writer.setPageMargins({});
    QPainter painter(&writer);
    painter.scale(shrunk * pdf_dots_per_inch / 96.0, shrunk * pdf_dots_per_inch / 96.0);
    view.paintDrawing(painter);
    painter.end();
    return bytes.data();
}

QByteArray png(PlanView& view) {
    const QSizeF size = view.drawingSize();
    const double scale = std::min({2.0, std::sqrt(most_pixels / (size.width() * size.height())),
                                   longest_side_px / std::max(size.width(), size.height())});
    QImage image((size * scale).toSize().expandedTo({1, 1}), QImage::Format_RGB32);
    if (image.isNull())
        return {};
    image.fill(tokens(Theme::Light).background);
    QPainter painter(&image);
    painter.scale(scale, scale);
    view.paintDrawing(painter);
    painter.end();
    QBuffer bytes;
    bytes.open(QIODevice::WriteOnly);
    return image.save(&bytes, "PNG") ? bytes.data() : QByteArray();
}

} // namespace

Result<void> savePlanPicture(PlanView& view, const QString& file) {
    const std::string where = file.toStdString();
    if (view.tree().empty())
        return failure("there is no plan to draw", where, "Choose a robot that has one");
    static const std::map<QString, QByteArray (*)(PlanView&)> formats{{"svg", svg}, {"pdf", pdf}, {"png", png}};
    const auto format = formats.find(QFileInfo(file).suffix().toLower());
    if (format == formats.end())
        return failure("the name does not say what kind of picture", where, "End it in .svg, .pdf or .png");
    const QByteArray bytes = format->second(view);
    if (bytes.isEmpty())
        return failure("the drawing is too large for the memory", where, "Fold some parts, or write it as .svg");
    QSaveFile out(file);
    if (!out.open(QIODevice::WriteOnly) || out.write(bytes) != bytes.size() || !out.commit())
        return failure("cannot be written: " + out.errorString().toStdString(), where, "Choose another folder");
    return {};
}

} // namespace usar::widgets
