#include "widgets/panels/file_choice.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QRegularExpression>

namespace usar::widgets {

QString withSuffix(const QString& path, const QString& suffix) {
    return path.isEmpty() || !QFileInfo(path).suffix().isEmpty() ? path : path + suffix;
}

QString askWhereToSave(QWidget* parent, const QString& title, const QString& proposal, const QString& filters) {
    QString chosen = filters.section(QStringLiteral(";;"), 0, 0);
    const QString path = QFileDialog::getSaveFileName(parent, title, proposal, filters, &chosen);
    return withSuffix(path, QRegularExpression(QStringLiteral("\\.\\w+")).match(chosen).captured());
}

} // namespace usar::widgets
