#include "widgets/models/preview_text.h"

#include <cmath>

#include <QCoreApplication>

#include "widgets/models/figures.h"

namespace usar::widgets {

namespace {

QString tr(const char* text, int n = -1) {
    return QCoreApplication::translate("PreviewText", text, nullptr, n);
}

/// `text` with spaces at which no line breaks.
QString together(QString text) {
    return text.replace(QChar::Space, QChar::Nbsp);
}

} // namespace

QString previewText(const agent::TaskPreview& preview) {
    return tr("%1 · %2 m · about %3")
        .arg(QString::fromStdString(preview.summary), figure(preview.length_m, 0),
             together(durationText(preview.duration)));
}

QString outlookText(const agent::TaskOutlook& outlook) {
    const QString sorties = together(outlook.least_sorties < outlook.most_sorties
                                         ? tr("%1 to %2 sorties").arg(outlook.least_sorties).arg(outlook.most_sorties)
                                     : outlook.most_sorties == 1 ? tr("one sortie")
                                                                 : tr("%1 sorties").arg(outlook.most_sorties));
    return tr("In the open: %1 to %2, %3, %4 to %5 % of the area shown")
        .arg(together(durationText(outlook.duration.least)), together(durationText(outlook.duration.most)), sorties,
             figure(std::floor(outlook.least_coverage_pct), 0), figure(std::ceil(outlook.most_coverage_pct), 0));
}

} // namespace usar::widgets
