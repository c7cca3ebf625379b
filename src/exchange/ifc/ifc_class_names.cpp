#include "src/exchange/ifc/ifc_class_names.hpp"

#include <algorithm>
#include <array>

namespace rubicon::ifc {

namespace {

/// Classes of products in IFC 2x3, 4 and 4.3, by subject.
constexpr auto kClasses = std::to_array<std::string_view>(
    {"IfcSite", "IfcBuilding", "IfcBuildingStorey", "IfcSpace", "IfcProject", "IfcSpatialZone",
     "IfcFacility", "IfcFacilityPart", "IfcBridge", "IfcBridgePart", "IfcRoad", "IfcRoadPart",
     "IfcRailway", "IfcRailwayPart", "IfcMarineFacility", "IfcMarinePart",
     "IfcExternalSpatialElement",
     // building
     "IfcWall", "IfcWallStandardCase", "IfcWallElementedCase", "IfcSlab", "IfcSlabStandardCase",
     "IfcSlabElementedCase", "IfcBeam", "IfcBeamStandardCase", "IfcColumn", "IfcColumnStandardCase",
     "IfcMember", "IfcMemberStandardCase", "IfcPlate", "IfcPlateStandardCase", "IfcStair",
     "IfcStairFlight", "IfcRamp", "IfcRampFlight", "IfcRoof", "IfcRailing", "IfcCovering",
     "IfcCurtainWall", "IfcDoor", "IfcDoorStandardCase", "IfcWindow", "IfcWindowStandardCase",
     "IfcFooting", "IfcPile", "IfcDeepFoundation", "IfcCaissonFoundation", "IfcBuildingElement",
     "IfcBuiltElement", "IfcBuildingElementProxy", "IfcBuildingElementPart", "IfcElementAssembly",
     "IfcChimney", "IfcShadingDevice", "IfcBearing", "IfcRail", "IfcTrackElement", "IfcPavement",
     "IfcKerb", "IfcCourse", "IfcEarthworksElement", "IfcEarthworksCut", "IfcEarthworksFill",
     "IfcReinforcedSoil", "IfcNavigationElement", "IfcMooringDevice", "IfcSign", "IfcSignal",
     "IfcVehicle", "IfcTransportElement", "IfcTransportationDevice", "IfcFurnishingElement",
     "IfcFurniture", "IfcSystemFurnitureElement", "IfcGeographicElement", "IfcCivilElement",
     "IfcGeotechnicalElement", "IfcDiscreteAccessory", "IfcFastener", "IfcMechanicalFastener",
     "IfcReinforcingBar", "IfcReinforcingMesh", "IfcTendon", "IfcTendonAnchor", "IfcTendonConduit",
     "IfcVibrationDamper", "IfcVibrationIsolator", "IfcSurfaceFeature", "IfcVoidingFeature",
     "IfcOpeningElement", "IfcOpeningStandardCase", "IfcProjectionElement", "IfcVirtualElement",
     "IfcAnnotation", "IfcGrid", "IfcProxy",
     // what places them
     "IfcGridPlacement", "IfcLinearPlacement",
     // services
     "IfcDistributionElement", "IfcDistributionFlowElement", "IfcDistributionControlElement",
     "IfcFlowSegment", "IfcFlowFitting", "IfcFlowTerminal", "IfcFlowController",
     "IfcFlowMovingDevice", "IfcFlowStorageDevice", "IfcFlowTreatmentDevice",
     "IfcEnergyConversionDevice"});

bool equal_in_capitals(std::string_view name, std::string_view keyword) {
  return std::equal(name.begin(), name.end(), keyword.begin(), keyword.end(), [](char a, char b) {
    return (a >= 'a' && a <= 'z' ? static_cast<char>(a - 'a' + 'A') : a) == b;
  });
}

}  // namespace

std::string class_name(std::string_view keyword) {
  for (const std::string_view name : kClasses) {
    if (equal_in_capitals(name, keyword)) return std::string(name);
  }
  std::string name(keyword);
  for (std::size_t i = 1; i < name.size(); ++i) {
    const bool initial = i == 3 && keyword.starts_with("IFC");
    if (!initial && name[i] >= 'A' && name[i] <= 'Z') {
      name[i] = static_cast<char>(name[i] - 'A' + 'a');
    }
  }
  return name;
}

bool is_no_element(std::string_view keyword) {
  constexpr std::array<std::string_view, 12> kNone = {
      "IFCSPACE",          "IFCOPENINGELEMENT",   "IFCOPENINGSTANDARDCASE",
      "IFCVOIDINGFEATURE", "IFCVIRTUALELEMENT",   "IFCANNOTATION",
      "IFCGRID",           "IFCSPATIALZONE",      "IFCREFERENT",
      "IFCPORT",           "IFCDISTRIBUTIONPORT", "IFCEXTERNALSPATIALELEMENT"};
  return std::find(kNone.begin(), kNone.end(), keyword) != kNone.end() ||
         keyword.starts_with("IFCSTRUCTURAL") || keyword.starts_with("IFCALIGNMENT");
}

}  // namespace rubicon::ifc
