// SPDX-License-Identifier: MIT
// The files of shaders/, compiled in by CMake. Internal to render/gl/.
#pragma once

namespace polhode::shaders {

extern const char* const kScreenVert;
extern const char* const kBackdropVert;
extern const char* const kBackdropFrag;
extern const char* const kFloorVert;
extern const char* const kFloorFrag;
extern const char* const kWallVert;
extern const char* const kWallFrag;
extern const char* const kGlassVert;
extern const char* const kGlassFrag;
extern const char* const kTubeVert;
extern const char* const kTubeFrag;
extern const char* const kMeshVert;
extern const char* const kMeshFrag;
extern const char* const kLightGlsl;
extern const char* const kGlass_structGlsl;
extern const char* const kGlassGlsl;
extern const char* const kBehind_glassGlsl;
extern const char* const kSkyGlsl;
extern const char* const kNoiseGlsl;
extern const char* const kStrokeVert;
extern const char* const kStrokeFrag;
extern const char* const kStroke_depthFrag;
extern const char* const kSolidVert;
extern const char* const kSolidFrag;
extern const char* const kFlatVert;
extern const char* const kGlyphVert;
extern const char* const kGlyphFrag;
extern const char* const kRuleVert;
extern const char* const kRuleFrag;
extern const char* const kBoxFrag;
extern const char* const kCompositeFrag;
extern const char* const kAverageFrag;
extern const char* const kShapeVert;
extern const char* const kShapeFrag;

}  // namespace polhode::shaders
