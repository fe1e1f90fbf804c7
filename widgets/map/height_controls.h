// Below the height map in the layers panel: how its heights become colors.
#pragma once

#include <QCheckBox>
#include <QJsonObject>
#include <QWidget>

#include "widgets/map/height_layer.h"
#include "widgets/panels/quantity_box.h"

namespace usar::widgets {

/// Gray or color, and a range that follows the scan or is fixed, in meters. Starts as a new height layer looks. GUI
/// thread.
class HeightControls : public QWidget {
    Q_OBJECT
public:
    explicit HeightControls(QWidget* parent = nullptr);

    HeightLook look() const;
    /// Emits nothing.
    void setLook(const HeightLook& look);
    /// The range that the map shows now; fixing the range begins with it.
    void setShownRange(const mapping::HeightRange& range);

    /// The look for the settings.
    QJsonObject saveState() const;
    /// Emits lookChanged if the look changes; what `state` does not name stays.
    void restoreState(const QJsonObject& state);

signals:
    void lookChanged(const usar::widgets::HeightLook& look);

private:
    /// Shows the figures of a fixed range only, and tells the look.
    void tell();

    QCheckBox* gray_ = nullptr;
    QCheckBox* fixed_ = nullptr;
    QuantityBox* lowest_ = nullptr;
    QuantityBox* highest_ = nullptr;
};

} // namespace usar::widgets
